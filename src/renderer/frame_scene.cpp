// SPDX-License-Identifier: MIT
#include "renderer/frame_scene.h"

#include <array>

#include "renderer/shaders.h"

namespace lueur {
namespace {

uint64_t shadow_map_bytes(const LightView& light) {
  return uint64_t{light.shadow_side_px} * light.shadow_side_px * light.clip_from_world.size() *
         sizeof(float);
}

// A buffer has at least one entry.
std::vector<LobeData> never_empty(std::vector<LobeData> lobes) {
  if (lobes.empty()) lobes.emplace_back();
  return lobes;
}

}  // namespace

FrameScene::FrameScene(Recorder& frame, const SceneOnDevice& on_device, FrameGeometry geometry,
                       std::vector<LightView> lights, uint64_t kept_shadow_bytes)
    : frame_(frame),
      on_device_(on_device),
      geometry_(std::move(geometry)),
      lights_(std::move(lights)),
      shadow_maps_(lights_.size()),
      kept_(lights_.size()),
      bytes_to_keep_(kept_shadow_bytes),
      instances_(frame.upload(geometry_.instances)),
      deformed_(frame.upload(geometry_.deformed)),
      materials_(frame.upload(on_device.materials())),
      lobes_(frame.upload(never_empty(on_device.cosine_lobes().lobes))) {}

std::vector<Bound> FrameScene::buffers() const {
  return {{"instances", instances_}, {"deformed", deformed_}, {"materials", materials_}};
}

void FrameScene::draw_all(DrawList& list, bool cull, std::span<const uint32_t> without) const {
  std::array<bool, kMostMovingObjects + 1> is_left_out{};  // by InstanceData::object
  for (const uint32_t object : without) is_left_out[object + 1] = true;
  // The first of an item's instances from `i` on that is, or is not, left out.
  const auto next = [&](uint32_t i, uint32_t end, bool left_out) {
    while (i < end && is_left_out[geometry_.instances[i].object] != left_out) ++i;
    return i;
  };

  list.geometry(on_device_.vertices(), on_device_.indices());
  int32_t bound_material = kNone;
  for (const DrawItem& item : geometry_.draws) {
    const uint32_t end = item.first_instance + item.instance_count;
    uint32_t first = item.first_instance;
    if (!without.empty()) first = next(first, end, false);
    if (first == end) continue;
    const Material& material = on_device_.material(item.material);
    if (item.material != bound_material) {
      list.material(on_device_.material_set(item.material));
      list.push(DrawParams{static_cast<uint32_t>(item.material)});
      list.cull_back_faces(cull && !material.double_sided);
      bound_material = item.material;
    }
    list.front_face(!item.mirrored);
    while (first < end) {
      const uint32_t last = without.empty() ? end : next(first, end, true);
      list.indexed(item.index_count, item.first_index, item.vertex_offset, last - first, first);
      first = last == end ? end : next(last, end, false);
    }
  }
}

Image FrameScene::shadow_map(size_t light) {
  if (!shadow_maps_[light].valid()) shadow_maps_[light] = draw_shadow_map(lights_[light]);
  return shadow_maps_[light];
}

void FrameScene::give_back_shadow_map(size_t light) {
  if (kept_[light]) return;
  const uint64_t bytes = shadow_map_bytes(lights_[light]);
  if (bytes <= bytes_to_keep_) {
    bytes_to_keep_ -= bytes;
    kept_[light] = true;
    return;
  }
  frame_.release(shadow_maps_[light]);
  shadow_maps_[light] = {};
}

Image FrameScene::draw_shadow_map(const LightView& light) {
  const uint32_t side = light.shadow_side_px;
  const bool is_cube = light.clip_from_world.size() == 6;
  const Image map = is_cube ? frame_.cube("shadow_map", side, Format::d32f)
                            : frame_.image("shadow_map", {side, side}, Format::d32f);
  // Only masked materials need a fragment shader. Both kinds go into one map, which a pass clears:
  // one pipeline draws all.
  bool any_masked = false;
  for (const DrawItem& item : geometry_.draws)
    any_masked |= on_device_.material(item.material).alpha_mode == AlphaMode::mask;
  const gpu::GraphicsState state{.vertex = &shaders::renderer_shadow_vert,
                                 .fragment = any_masked ? &shaders::renderer_shadow_frag : nullptr,
                                 .depth_test = gpu::DepthTest::nearer_reversed,
                                 // What lies in front of a directional light's box still casts.
                                 .depth_clamp = !is_cube,
                                 .vertex_attributes = shadow_attributes(),
                                 .vertex_stride_bytes = sizeof(Vertex)};
  for (uint32_t layer = 0; layer < light.clip_from_world.size(); ++layer)
    frame_.draw("renderer.shadow", {.state = state,
                                    .params = ShadowParams{light.clip_from_world[layer]},
                                    .read = buffers(),
                                    .depth = DrawTarget{"shadow_map", map, {}, layer},
                                    .record = [&](DrawList& list) { draw_all(list, false); }});
  return map;
}

}  // namespace lueur
