// SPDX-License-Identifier: MIT
#include "renderer/view_passes.h"

#include <glm/gtc/type_ptr.hpp>

#include "frame/screen_of_view.h"
#include "renderer/shaders.h"

namespace lueur {
namespace {

glm::mat4 clip_from_world(const View& view) {
  return glm::make_mat4(view.clip_from_view.data()) * glm::make_mat4(view.view_from_world.data());
}

}  // namespace

ViewPasses::ViewPasses(FrameScene& scene, std::string name, Extent extent, const View& view,
                       const View& view_before)
    : scene_(scene),
      frame_(scene.frame()),
      name_(std::move(name)),
      extent_(extent),
      view_(view),
      view_before_(view_before) {}

void ViewPasses::show_surfaces(bool emission, std::span<const uint32_t> without) {
  emission_ = emission;
  draw_g_buffer(without);
  images_.albedo = frame_.image("albedo", extent_, Format::rgba16f);
  images_.source = frame_.image("source", extent_, Format::rgba16f);
  images_.specular = frame_.image("specular", extent_, Format::rgba16f);
  frame_.dispatch(name_ + ".surface",
                  {.shader = shaders::renderer_surface_comp,
                   .params = SurfaceParams{as_ivec2(extent_), emission ? 1u : 0u},
                   .read = {{"base_color", base_color_},
                            {"material", images_.material},
                            {"emission", images_.emission}},
                   .write = {{"albedo", images_.albedo},
                             {"source", images_.source},
                             {"specular", images_.specular}},
                   .over = extent_});
}

void ViewPasses::draw_g_buffer(std::span<const uint32_t> without) {
  images_.depth = frame_.image("depth", extent_, Format::d32f);
  images_.normal = frame_.image("normal", extent_, Format::rg16_snorm);
  images_.material = frame_.image("material", extent_, Format::rgba8);
  images_.emission = frame_.image("emission", extent_, Format::rgba16f);
  images_.motion = frame_.image("motion", extent_, Format::rg16f);
  base_color_ = frame_.image("base_color", extent_, Format::rgba8_srgb);
  frame_.draw(name_ + ".g_buffer",
              {.state = {.vertex = &shaders::renderer_g_buffer_vert,
                         .fragment = &shaders::renderer_g_buffer_frag,
                         .depth_test = gpu::DepthTest::nearer_reversed,
                         .vertex_attributes = g_buffer_attributes(),
                         .vertex_stride_bytes = sizeof(Vertex)},
               .params = GBufferParams{clip_from_world(view_), clip_from_world(view_before_)},
               .read = scene_.buffers(),
               .color = {{"base_color", base_color_},
                         {"normal", images_.normal},
                         {"material", images_.material},
                         {"emission", images_.emission},
                         {"motion", images_.motion}},
               .depth = DrawTarget{"depth", images_.depth},
               .record = [&](DrawList& list) { scene_.draw_all(list, true, without); }});
}

void ViewPasses::add_light(size_t index) {
  const LightView& light = scene_.lights()[index];
  LightParams params = light.params;
  params.screen = screen_of_view(view_, extent_);
  params.world_from_view = glm::inverse(glm::make_mat4(view_.view_from_world.data()));
  params.extent = as_ivec2(extent_);
  const bool is_cube = light.clip_from_world.size() == 6;
  frame_.dispatch(
      name_ + ".light",
      {.shader = is_cube ? shaders::renderer_light_cube_comp : shaders::renderer_light_flat_comp,
       .params = params,
       .read = {{"depth", images_.depth},
                {"normal", images_.normal},
                {"base_color", base_color_},
                {"material", images_.material},
                {"lobes", scene_.lobes()},
                {"shadow_map",
                 scene_.shadow_map(index),
                 {.filter = gpu::Filter::linear, .compare = true}}},
       .write = {{"source", images_.source}, {"specular", images_.specular}},
       .over = extent_});
  scene_.give_back_shadow_map(index);
}

bool ViewPasses::gives_emission() const {
  return emission_ && scene_.on_device().emits();
}

GBuffer ViewPasses::g_buffer(bool objects) {
  GBuffer g{.depth = images_.depth,
            .normal = images_.normal,
            .source = images_.source,
            .motion = images_.motion,
            .albedo = images_.albedo,
            .reflectance = frame_.image("reflectance", extent_, Format::rgba16f)};
  frame_.dispatch(name_ + ".reflectance", {.shader = shaders::renderer_reflectance_comp,
                                           .params = ReflectanceParams{as_ivec2(extent_)},
                                           .read = {{"base_color", base_color_},
                                                    {"material", images_.material},
                                                    {"lobes", scene_.lobes()}},
                                           .write = {{"reflectance", g.reflectance}},
                                           .over = extent_});
  if (objects && scene_.on_device().moving_objects().count > 0) g.object = object_image();
  g.emission = images_.emission;
  if (scene_.on_device().keeps_light()) pass_on(g);
  if (!gives_emission()) g.emission = {};
  return g;
}

Image ViewPasses::object_image() {
  const Image object = frame_.image("object", extent_, Format::r8);
  frame_.dispatch(name_ + ".object", {.shader = shaders::renderer_object_comp,
                                      .params = ObjectParams{as_ivec2(extent_)},
                                      .read = {{"base_color", base_color_}},
                                      .write = {{"object", object}},
                                      .over = extent_});
  return object;
}

void ViewPasses::pass_on(GBuffer& g) {
  g.albedo = frame_.image("albedo_passed_on", extent_, Format::rgba16f);
  g.emission = frame_.image("emission_passed_on", extent_, Format::rgba16f);
  frame_.dispatch(name_ + ".passed_on",
                  {.shader = shaders::renderer_passed_on_comp,
                   .params = PassedOnParams{as_ivec2(extent_)},
                   .read = {{"material", images_.material},
                            {"albedo", images_.albedo},
                            {"emission", images_.emission}},
                   .write = {{"albedo_passed_on", g.albedo}, {"emission_passed_on", g.emission}},
                   .over = extent_});
}

void ViewPasses::release_surfaces() {
  frame_.release(base_color_);
  base_color_ = {};
}

void ViewPasses::release_all_but(const GBuffer& given) {
  release_surfaces();
  for (const Image& image :
       {images_.material, images_.motion, images_.specular, images_.emission, images_.albedo})
    if (image.index != given.emission.index && image.index != given.albedo.index &&
        image.index != given.motion.index)
      frame_.release(image);
  images_ = {};
}

}  // namespace lueur
