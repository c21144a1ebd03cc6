// SPDX-License-Identifier: MIT
#include "renderer/scene_host.h"

#include <algorithm>
#include <cstddef>
#include <glm/gtc/type_ptr.hpp>

#include "base/check.h"
#include "renderer/view_passes.h"
#include "scene/placed_light.h"

namespace lueur {
namespace {

std::array<float, 3> array_of(const glm::vec3& v) {
  return {v.x, v.y, v.z};
}

Box as_box(const Bounds& bounds) {
  return {array_of(bounds.min), array_of(bounds.max)};
}

constexpr uint32_t floats(size_t bytes) {
  return static_cast<uint32_t>(bytes / sizeof(float));
}

// Ranges of all that is drawn, in two batches: what lies where its mesh has it, and what skins and
// morph targets have moved.
std::vector<TriangleBatch> batches_of(const FrameScene& scene, BufferRef vertices,
                                      BufferRef indices) {
  TriangleBatch still{.vertices = vertices,
                      .indices = indices,
                      .first_float = floats(offsetof(Vertex, position)),
                      .stride_floats = floats(sizeof(Vertex))};
  TriangleBatch moved{.vertices = scene.deformed(),
                      .indices = indices,
                      .first_float = floats(offsetof(DeformedVertex, position)),
                      .stride_floats = floats(sizeof(DeformedVertex))};
  const FrameGeometry& geometry = scene.geometry();
  for (const DrawItem& item : geometry.draws) {
    for (uint32_t i = 0; i < item.instance_count; ++i) {
      const InstanceData& instance = geometry.instances[item.first_instance + i];
      const bool is_deformed = instance.is_deformed != 0;
      TriangleBatch& batch = is_deformed ? moved : still;
      TriangleRange range{
          .first_index = item.first_index,
          .vertex_offset = item.vertex_offset + (is_deformed ? instance.first_deformed : 0)};
      std::copy_n(glm::value_ptr(instance.world_from_object), 16, range.world_from_object.begin());
      const uint32_t end = item.first_index + item.index_count;
      range.closed = true;
      for (const SolidPart& part : item.solids) {
        range.index_count = part.index_count;
        range.thickness = part.thickness_m;
        batch.ranges.push_back(range);
        range.first_index += part.index_count;
      }
      range.closed = false;
      range.thickness = 0.0f;
      range.index_count = end - range.first_index;
      if (range.index_count > 0) batch.ranges.push_back(range);
    }
  }
  std::vector<TriangleBatch> batches;
  for (TriangleBatch* batch : {&still, &moved})
    if (!batch->ranges.empty()) batches.push_back(std::move(*batch));
  return batches;
}

}  // namespace

SceneHost::SceneHost(FrameScene& frame_scene, const Scene& scene,
                     const std::vector<glm::mat4>& world_from_node,
                     std::span<const Bounds> of_instances, const Background* background)
    : scene_(frame_scene), bounds_(as_box(bounds_around(of_instances))), background_(background) {
  for (const Bounds& box :
       bounds_of_objects(frame_scene.on_device().moving_objects(), of_instances))
    objects_.push_back({as_box(box)});
  for (const Light& light : scene.lights)
    lights_.push_back(as_punctual(place(light, world_from_node[static_cast<size_t>(light.node)])));
}

GBuffer SceneHost::render_view(Frame&, const View& view, Extent extent,
                               const ViewContent& content) {
  const int32_t light = content.light;
  const auto count = static_cast<int32_t>(lights_.size());
  LUEUR_CHECK(light == kAllLights || (light >= 0 && light < count));
  for (const uint32_t object : content.without) LUEUR_CHECK_OP(object, <, objects_.size());
  ViewPasses passes(scene_, "renderer.view", extent, view, view);
  passes.show_surfaces(light == kAllLights, content.without);
  for (int32_t i = 0; i < count; ++i)
    if (light == kAllLights || light == i) passes.add_light(static_cast<size_t>(i));
  GBuffer g = passes.g_buffer(content.objects);
  // The view of the frame before is not known.
  g.motion = {};
  passes.release_all_but(g);
  return g;
}

Image SceneHost::background(Frame&, const View& view, Extent extent) {
  return background_ ? background_->alone(scene_.frame(), view, extent) : Image{};
}

std::span<const TriangleBatch> SceneHost::triangles(Frame& frame) {
  if (batches_.empty()) {
    // Uploaded before the first frame, and waited for.
    const auto lent = [&](const gpu::Buffer& buffer) {
      return frame.import(ExternalBuffer{.buffer = buffer.handle(), .bytes = buffer.bytes()});
    };
    batches_ =
        batches_of(scene_, lent(scene_.on_device().vertices()), lent(scene_.on_device().indices()));
  }
  return batches_;
}

}  // namespace lueur
