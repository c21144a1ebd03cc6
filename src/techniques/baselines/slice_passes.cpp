// SPDX-License-Identifier: MIT
#include "techniques/baselines/slice_passes.h"

#include <glm/gtc/type_ptr.hpp>

#include "frame/screen_of_view.h"
#include "techniques/baselines/params.h"
#include "techniques/baselines/shaders.h"
#include "techniques/joint_filter.h"
#include "techniques/shaders.h"

namespace lueur {

SlicePasses::SlicePasses(Recorder& frame, std::string name, const Inputs& inputs)
    : frame_(frame),
      name_(std::move(name)),
      inputs_(inputs),
      extent_(inputs.g_buffer.depth.extent),
      screen_(screen_of_view(inputs.view, extent_)) {}

Image SlicePasses::geometry() {
  const glm::mat3 view_from_world(glm::make_mat4(inputs_.view.view_from_world.data()));
  const Image geometry = frame_.image("geometry", extent_, Format::rgba32f);
  frame_.dispatch(name_ + ".geometry",
                  {.shader = shaders::techniques_baselines_geometry_comp,
                   .params = GeometryParams{{screen_, view_from_world, as_ivec2(extent_)}},
                   .read = {{"depth", inputs_.g_buffer.depth}, {"normal", inputs_.g_buffer.normal}},
                   .write = {{"geometry", geometry}},
                   .over = extent_});
  return geometry;
}

Image SlicePasses::average(const char* pass, Image geometry, Image light, int32_t step_px) {
  const Image filtered = frame_.image("filtered", extent_, Format::rgba16f);
  frame_.dispatch(name_ + pass, {.shader = shaders::techniques_joint_filter_comp,
                                 .params = FilterParams{screen_, as_ivec2(extent_), step_px},
                                 .read = {{"geometry", geometry}, {"light", light}},
                                 .write = {{"filtered", filtered}},
                                 .over = extent_});
  frame_.release(light);
  return filtered;
}

Image SlicePasses::filter(Image geometry, Image light) {
  return average(".filter", geometry, light, 1);
}

Image SlicePasses::widen(Image geometry, Image light) {
  return average(".widen", geometry, light, 3);
}

Image SlicePasses::occlusion(Image light) {
  const Image occlusion = frame_.image("occlusion", extent_, Format::r16f);
  frame_.dispatch(name_ + ".occlusion", {.shader = shaders::techniques_baselines_occlusion_comp,
                                         .params = OcclusionParams{as_ivec2(extent_)},
                                         .read = {{"light", light}},
                                         .write = {{"occlusion", occlusion}},
                                         .over = extent_});
  return occlusion;
}

}  // namespace lueur
