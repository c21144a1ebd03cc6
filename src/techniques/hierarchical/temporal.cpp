// SPDX-License-Identifier: MIT
#include <glm/gtc/type_ptr.hpp>

#include "frame/screen_of_view.h"
#include "techniques/hierarchical/hierarchical_frame.h"
#include "techniques/hierarchical/shaders.h"

namespace lueur::hierarchical {
namespace {

std::string history_name(const std::string& name) {
  return "hierarchical." + name;
}

}  // namespace

bool HierarchicalFrame::has_history() const {
  const bool wanted = settings_.temporal > 0.0f || settings_.feedback || settings_.interleave;
  return wanted && inputs_.g_buffer.motion.valid();
}

Warped HierarchicalFrame::warp(const Pyramid& pyramid, const std::string& name,
                               const Lobes* lobes) {
  const Level& level = pyramid.finest();
  const HistoryImage history = frame_.history(history_name(name), level.extent, Format::rgba16f);
  light_history_[name] = history;
  if (!history.valid || !geometry_history_.valid || inputs_.cut) return {};
  const GBuffer& g = pyramid.g_buffer;
  WarpParams params{};
  params.screen = pyramid.screen;
  params.previous = screen_of_view(inputs_.previous_view, g.depth.extent);
  params.previous_view_from_view =
      glm::make_mat4(inputs_.previous_view.view_from_world.data()) * pyramid.world_from_view;
  params.full_extent = as_ivec2(g.depth.extent);
  params.extent = as_ivec2(level.extent);
  params.most = settings_.temporal;
  const Image warped = frame_.image("warped", level.extent, Format::rgba16f);
  Dispatch dispatch{.shader = lobes ? shaders::techniques_hierarchical_warp_glossy_comp
                                    : shaders::techniques_hierarchical_warp_comp,
                    .constants = {{"factor", static_cast<uint32_t>(pyramid.factor)}},
                    .params = params,
                    .read = {{"depth", g.depth},
                             {"motion", g.motion},
                             {"geometry", level.geometry},
                             {"geometry_there", geometry_history_.previous},
                             {"light_there", history.previous}},
                    .write = {{"warped", warped}},
                    .over = level.extent};
  if (lobes) {
    dispatch.read.push_back({"lobe", lobes->codes});
    dispatch.read.push_back({"lobes", lobes->table});
  }
  frame_.dispatch("hierarchical.warp", dispatch);
  return {warped};
}

Image HierarchicalFrame::blend(const Pyramid& pyramid, const std::string& name,
                               const Warped& warped, Image light) {
  return blend_with(pyramid, name, warped.light, light);
}

Image HierarchicalFrame::carry(const Pyramid& pyramid, const std::string& name,
                               const Warped& warped) {
  return blend_with(pyramid, name, warped.light, {});
}

// Either of the two may be invalid.
Image HierarchicalFrame::blend_with(const Pyramid& pyramid, const std::string& name, Image warped,
                                    Image light) {
  const Extent extent = pyramid.finest().extent;
  const Image blended = frame_.image("blended", extent, Format::rgba16f);
  // What is bound in place of a missing image is not looked at.
  const Image any = light.valid() ? light : warped.valid() ? warped : pyramid.finest().source;
  frame_.dispatch(
      "hierarchical.temporal",
      {.shader = shaders::techniques_hierarchical_temporal_comp,
       .constants = {{"clamp_history", settings_.temporal_clamp ? 1u : 0u}},
       .params =
           TemporalParams{as_ivec2(extent), light.valid() ? 1u : 0u, warped.valid() ? 1u : 0u},
       .read = {{"light", light.valid() ? light : any}, {"warped", warped.valid() ? warped : any}},
       .write = {{"blended", blended}, {"history", light_history_.at(name).current}},
       .over = extent});
  return blended;
}

}  // namespace lueur::hierarchical
