// SPDX-License-Identifier: MIT
#include "renderer/renderer.h"

#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "base/check.h"
#include "base/try.h"
#include "renderer/background.h"
#include "renderer/light_view.h"
#include "renderer/params.h"
#include "renderer/scene_on_device.h"
#include "renderer/shaders.h"
#include "techniques/screen_of_view.h"

namespace lueur {

struct Renderer::State {
  Scene scene;  // without its texels and the pixels of its environment
  std::unique_ptr<SceneOnDevice> on_device;
  std::optional<Background> background;
  std::vector<std::string> warnings;
};

namespace {

ivec2 as_ivec2(Extent e) {
  return ivec2(e.width, e.height);
}

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

glm::mat4 clip_from_world(const View& view) {
  return glm::make_mat4(view.clip_from_view.data()) * glm::make_mat4(view.view_from_world.data());
}

ScenePose pose_at(const Scene& scene, float time_s) {
  std::vector<glm::mat4> world_from_node = pose(scene, time_s);
  std::vector<DeformedInstance> deformed = deformed_instances(scene, world_from_node, time_s);
  return {std::move(world_from_node), std::move(deformed)};
}

// One frame: what all passes share.
struct FramePasses {
  Recorder& frame;
  const SceneOnDevice& scene;
  const Shot& shot;
  View view;
  View view_before;
  std::vector<DrawItem> draws;
  BufferRef instances;
  BufferRef deformed;
  BufferRef materials;

  void g_buffer(RenderedImages& images, Image base_color);
  void surface(RenderedImages& images, Image base_color);
  Image shadow_map(const LightView& light);
  void light(const RenderedImages& images, Image base_color, const LightView& light, Image shadows);
  void compose(RenderedImages& images);
  void draw_all(DrawList& list, bool cull);
};

// Draws every item, changing state only where it changes. `cull`: the backs of one-sided materials.
void FramePasses::draw_all(DrawList& list, bool cull) {
  list.geometry(scene.vertices(), scene.indices());
  int32_t bound_material = kNone;
  for (const DrawItem& item : draws) {
    const Material& material = scene.material(item.material);
    if (item.material != bound_material) {
      list.material(scene.material_set(item.material));
      list.push(DrawParams{static_cast<uint32_t>(item.material)});
      list.cull_back_faces(cull && !material.double_sided);
      bound_material = item.material;
    }
    list.front_face(!item.mirrored);
    list.indexed(item.index_count, item.first_index, item.vertex_offset, item.instance_count,
                 item.first_instance);
  }
}

void FramePasses::g_buffer(RenderedImages& images, Image base_color) {
  frame.draw("renderer.g_buffer",
             {.state = {.vertex = &shaders::renderer_g_buffer_vert,
                        .fragment = &shaders::renderer_g_buffer_frag,
                        .depth_test = gpu::DepthTest::nearer_reversed,
                        .vertex_attributes = g_buffer_attributes(),
                        .vertex_stride_bytes = sizeof(Vertex)},
              .params = GBufferParams{clip_from_world(view), clip_from_world(view_before)},
              .read = {{"instances", instances}, {"deformed", deformed}, {"materials", materials}},
              .color = {{"base_color", base_color},
                        {"normal", images.normal},
                        {"material", images.material},
                        {"emission", images.emission},
                        {"motion", images.motion}},
              .depth = DrawTarget{"depth", images.depth},
              .record = [&](DrawList& list) { draw_all(list, true); }});
}

void FramePasses::surface(RenderedImages& images, Image base_color) {
  frame.dispatch("renderer.surface", {.shader = shaders::renderer_surface_comp,
                                      .params = ComposeParams{as_ivec2(shot.extent), 0},
                                      .read = {{"base_color", base_color},
                                               {"material", images.material},
                                               {"emission", images.emission}},
                                      .write = {{"albedo", images.albedo},
                                                {"source", images.source},
                                                {"specular", images.specular}},
                                      .over = shot.extent});
}

Image FramePasses::shadow_map(const LightView& light) {
  const uint32_t side = light.shadow_side_px;
  const bool is_cube = light.clip_from_world.size() == 6;
  const Image map = is_cube ? frame.cube("shadow_map", side, Format::d32f)
                            : frame.image("shadow_map", {side, side}, Format::d32f);
  for (uint32_t layer = 0; layer < light.clip_from_world.size(); ++layer) {
    // Only masked materials need a fragment shader. Both kinds go into one map, which a pass
    // clears: one pipeline draws all.
    bool any_masked = false;
    for (const DrawItem& item : draws)
      any_masked |= scene.material(item.material).alpha_mode == AlphaMode::mask;
    gpu::GraphicsState state{.vertex = &shaders::renderer_shadow_vert,
                             .fragment = any_masked ? &shaders::renderer_shadow_frag : nullptr,
                             .depth_test = gpu::DepthTest::nearer_reversed,
                             // What lies in front of a directional light's box still casts.
                             .depth_clamp = !is_cube,
                             .vertex_attributes = shadow_attributes(),
                             .vertex_stride_bytes = sizeof(Vertex)};
    frame.draw(
        "renderer.shadow",
        {.state = state,
         .params = ShadowParams{light.clip_from_world[layer]},
         .read = {{"instances", instances}, {"deformed", deformed}, {"materials", materials}},
         .depth = DrawTarget{"shadow_map", map, {}, layer},
         .record = [&](DrawList& list) { draw_all(list, false); }});
  }
  return map;
}

void FramePasses::light(const RenderedImages& images, Image base_color, const LightView& light,
                        Image shadows) {
  LightParams params = light.params;
  params.screen = screen_of_view(view, shot.extent);
  params.world_from_view = glm::inverse(glm::make_mat4(view.view_from_world.data()));
  params.extent = as_ivec2(shot.extent);
  const bool is_cube = light.clip_from_world.size() == 6;
  frame.dispatch(
      "renderer.light",
      {.shader = is_cube ? shaders::renderer_light_cube_comp : shaders::renderer_light_flat_comp,
       .params = params,
       .read = {{"depth", images.depth},
                {"normal", images.normal},
                {"base_color", base_color},
                {"material", images.material},
                {"shadow_map", shadows, {.filter = gpu::Filter::linear, .compare = true}}},
       .write = {{"source", images.source}, {"specular", images.specular}},
       .over = shot.extent});
}

void FramePasses::compose(RenderedImages& images) {
  const bool has_indirect = images.indirect.valid();
  frame.dispatch("renderer.compose",
                 {.shader = shaders::renderer_compose_comp,
                  .params = ComposeParams{as_ivec2(shot.extent), has_indirect ? 1u : 0u},
                  .read = {{"source", images.source},
                           {"albedo", images.albedo},
                           {"specular", images.specular},
                           {"indirect", has_indirect ? images.indirect : images.source}},
                  .write = {{"composed", images.composed}},
                  .over = shot.extent});
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
  for (const Material& material : scene.materials)
    if (material.phong)
      state->warnings.push_back("material '" + material.name +
                                "': its Phong lobe is left out of direct light");
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
  const FrameGeometry geometry = state_->on_device->pose(now, before);

  FramePasses passes{frame,
                     *state_->on_device,
                     shot,
                     view_of_camera(camera, now.world_from_node[node], shot.extent),
                     view_of_camera(camera, before.world_from_node[node], shot.extent),
                     geometry.draws,
                     frame.upload(geometry.instances),
                     frame.upload(geometry.deformed),
                     frame.upload(state_->on_device->materials())};

  RenderedImages images;
  images.depth = frame.image("depth", shot.extent, Format::d32f);
  images.normal = frame.image("normal", shot.extent, Format::rg16_snorm);
  images.material = frame.image("material", shot.extent, Format::rgba8);
  images.emission = frame.image("emission", shot.extent, Format::rgba16f);
  images.motion = frame.image("motion", shot.extent, Format::rg16f);
  const Image base_color = frame.image("base_color", shot.extent, Format::rgba8_srgb);
  passes.g_buffer(images, base_color);

  images.albedo = frame.image("albedo", shot.extent, Format::rgba16f);
  images.source = frame.image("source", shot.extent, Format::rgba16f);
  images.specular = frame.image("specular", shot.extent, Format::rgba16f);
  passes.surface(images, base_color);
  const Bounds box = bounds(scene, now.world_from_node, now.deformed);
  for (const Light& light : scene.lights) {
    const LightView view =
        view_of_light(light, now.world_from_node[static_cast<size_t>(light.node)], box);
    const Image shadows = passes.shadow_map(view);
    passes.light(images, base_color, view, shadows);
    frame.release(shadows);
  }
  frame.release(base_color);

  if (technique) {
    const Inputs inputs{
        .view = passes.view,
        .g_buffer = {.depth = images.depth, .normal = images.normal, .source = images.source},
        .seed = shot.seed};
    images.indirect = technique->render(public_frame, inputs).diffuse;
  }
  images.composed = frame.image("composed", shot.extent, Format::rgba16f);
  passes.compose(images);
  if (state_->background)
    state_->background->record(frame, shot.extent, world_from_camera(now.world_from_node[node]),
                               camera.vertical_fov_rad, images.depth, images.composed);
  return images;
}

}  // namespace lueur
