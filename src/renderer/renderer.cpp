// SPDX-License-Identifier: MIT
#include "renderer/renderer.h"

#include <glm/gtc/type_ptr.hpp>
#include <map>
#include <utility>

#include "base/check.h"
#include "base/try.h"
#include "frame/screen_of_view.h"
#include "renderer/background.h"
#include "renderer/light_view.h"
#include "renderer/params.h"
#include "renderer/scene_host.h"
#include "renderer/scene_on_device.h"
#include "renderer/shaders.h"
#include "renderer/view_passes.h"

namespace lueur {

struct Renderer::State {
  Scene scene;  // without its texels and the pixels of its environment
  std::unique_ptr<SceneOnDevice> on_device;
  std::optional<Background> background;
  std::vector<std::string> warnings;
  // What the last frame of each history has shown.
  struct Shown {
    int32_t camera = kNone;
    Extent extent;
    bool operator==(const Shown&) const = default;
  };
  std::map<std::string, Shown> shown;

  // Whether what this frame shows does not go on from the history's last one.
  bool is_cut(const std::string& history, const Shot& shot) {
    const Shown now{shot.camera, shot.extent};
    return std::exchange(shown[history], now) != now || shot.cut;
  }
};

namespace {

// For further views of a frame. Enough for eight spots or two suns.
constexpr uint64_t kKeptShadowBytes = uint64_t{128} << 20;

View view_of_camera(const Camera& camera, const glm::mat4& world_from_node, Extent extent) {
  const glm::mat4 view_from_world = glm::inverse(world_from_camera(world_from_node));

  // Reversed z, no far plane, y down in clip space.
  const float f = 1.0f / std::tan(0.5f * camera.vertical_fov_rad);
  glm::mat4 clip_from_view(0.0f);
  clip_from_view[0][0] = f * static_cast<float>(extent.height) / static_cast<float>(extent.width);
  clip_from_view[1][1] = -f;
  clip_from_view[2][3] = -1.0f;
  clip_from_view[3][2] = camera.near_m;

  View view;
  std::copy_n(glm::value_ptr(view_from_world), 16, view.view_from_world.begin());
  std::copy_n(glm::value_ptr(clip_from_view), 16, view.clip_from_view.begin());
  return view;
}

ScenePose pose_at(const Scene& scene, float time_s) {
  std::vector<glm::mat4> world_from_node = pose(scene, time_s);
  std::vector<DeformedInstance> deformed = deformed_instances(scene, world_from_node, time_s);
  return {std::move(world_from_node), std::move(deformed)};
}

void compose(Recorder& frame, RenderedImages& images) {
  const Extent extent = images.depth.extent;
  images.composed = frame.image("composed", extent, Format::rgba16f);
  const bool diffuse = images.indirect.valid(), specular = images.indirect_specular.valid();
  frame.dispatch(
      "renderer.compose",
      {.shader = shaders::renderer_compose_comp,
       .params = ComposeParams{as_ivec2(extent), diffuse ? 1u : 0u, specular ? 1u : 0u},
       .read = {{"source", images.source},
                {"albedo", images.albedo},
                {"specular", images.specular},
                {"indirect", diffuse ? images.indirect : images.source},
                {"indirect_specular", specular ? images.indirect_specular : images.source}},
       .write = {{"composed", images.composed}},
       .over = extent});
}

// Of a technique that gives nothing but occlusion.
void compose_occluded(Recorder& frame, RenderedImages& images) {
  const Extent extent = images.depth.extent;
  images.composed = frame.image("composed", extent, Format::rgba16f);
  frame.dispatch("renderer.compose_occluded", {.shader = shaders::renderer_compose_occluded_comp,
                                               .params = ComposeOccludedParams{as_ivec2(extent)},
                                               .read = {{"source", images.source},
                                                        {"emission", images.emission},
                                                        {"specular", images.specular},
                                                        {"occlusion", images.occlusion}},
                                               .write = {{"composed", images.composed}},
                                               .over = extent});
}

}  // namespace

View view_of(const Scene& scene, const Shot& shot) {
  const Camera& camera = scene.cameras[static_cast<size_t>(shot.camera)];
  const std::vector<glm::mat4> posed = pose(scene, shot.time_s);
  return view_of_camera(camera, posed[static_cast<size_t>(camera.node)], shot.extent);
}

Renderer::Renderer(std::unique_ptr<State> state) : state_(std::move(state)) {}
Renderer::~Renderer() = default;

const std::vector<std::string>& Renderer::warnings() const {
  return state_->warnings;
}

Result<std::unique_ptr<Renderer>> Renderer::create(gpu::System& system, Context& context,
                                                   const Scene& scene) {
  LUEUR_CHECK(!scene.cameras.empty());
  auto state = std::make_unique<State>();
  LUEUR_TRY(on_device, SceneOnDevice::create(system, context, scene));
  state->on_device = std::move(on_device);
  if (scene.environment) {
    LUEUR_TRY(background, Background::create(system, context, *scene.environment));
    state->background = std::move(background);
  }
  state->scene = scene;
  if (const size_t left_out = state->on_device->cosine_lobes().left_out)
    state->warnings.push_back(std::to_string(left_out) + " materials reflect by no Phong lobe: " +
                              std::to_string(kMostCosineLobes) + " different ones find room");
  for (Texture& texture : state->scene.textures) texture.rgba.clear();
  if (state->scene.environment) state->scene.environment->rgb.clear();
  return std::unique_ptr<Renderer>(new Renderer(std::move(state)));
}

RenderedImages Renderer::record(Frame& public_frame, const Shot& shot, Technique* technique) {
  Recorder& frame = public_frame.recorder();
  const Scene& scene = state_->scene;
  LUEUR_CHECK(shot.camera >= 0 && shot.camera < static_cast<int32_t>(scene.cameras.size()));
  const Camera& camera = scene.cameras[static_cast<size_t>(shot.camera)];
  const auto node = static_cast<size_t>(camera.node);
  const ScenePose now = pose_at(scene, shot.time_s);
  const ScenePose before = pose_at(scene, shot.previous_time_s);
  const std::vector<Bounds> of_instances =
      bounds_of_instances(scene, now.world_from_node, now.deformed);
  const Bounds box = bounds_around(of_instances);
  std::vector<LightView> lights;
  for (const Light& light : scene.lights)
    lights.push_back(
        view_of_light(light, now.world_from_node[static_cast<size_t>(light.node)], box));
  FrameScene frame_scene(frame, *state_->on_device, state_->on_device->pose(now, before),
                         std::move(lights), technique ? kKeptShadowBytes : 0);

  const View view = view_of_camera(camera, now.world_from_node[node], shot.extent);
  const View view_before = view_of_camera(camera, before.world_from_node[node], shot.extent);
  ViewPasses passes(frame_scene, "renderer", shot.extent, view, view_before);
  passes.show_surfaces(true);
  for (size_t i = 0; i < scene.lights.size(); ++i) passes.add_light(i);
  RenderedImages images = passes.images();

  const bool cut = state_->is_cut(frame.options.history_of, shot);
  if (technique) {
    SceneHost host(frame_scene, scene, now.world_from_node, of_instances,
                   state_->background ? &*state_->background : nullptr);
    std::vector<View> side_views;
    for (const int32_t index : shot.side_cameras) {
      LUEUR_CHECK(index >= 0 && index < static_cast<int32_t>(scene.cameras.size()));
      const Camera& side = scene.cameras[static_cast<size_t>(index)];
      side_views.push_back(
          view_of_camera(side, now.world_from_node[static_cast<size_t>(side.node)], shot.extent));
    }
    const Inputs inputs{.view = view,
                        .g_buffer = passes.g_buffer(true),
                        .seed = shot.seed,
                        .previous_view = view_before,
                        .cut = cut,
                        .lobes = state_->on_device->cosine_lobes().shapes,
                        .side_views = side_views,
                        .host = &host};
    passes.release_surfaces();
    const Outputs outputs = technique->render(public_frame, inputs);
    images.indirect = outputs.diffuse;
    images.indirect_specular = outputs.specular;
    images.occlusion = outputs.occlusion;
  }
  if (images.occlusion.valid() && !images.indirect.valid() && !images.indirect_specular.valid())
    compose_occluded(frame, images);
  else
    compose(frame, images);
  if (state_->background) state_->background->record(frame, view, images.depth, images.composed);
  return images;
}

}  // namespace lueur
