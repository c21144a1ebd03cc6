// SPDX-License-Identifier: MIT
// Sources that other views see. Beyond the papers: receivers and sources need not be of one view.
#include <cmath>

#include "lights/light_views.h"
#include "techniques/hierarchical/equations.h"
#include "techniques/hierarchical/hierarchical_frame.h"
#include "techniques/hierarchical/shaders.h"

namespace lueur::hierarchical {
namespace {

// Levels whose rings reach across a whole view from any of its pixels.
uint32_t levels_across(Extent extent, float radius_px) {
  const float diagonal_px =
      std::hypot(static_cast<float>(extent.width), static_cast<float>(extent.height));
  uint32_t levels = 1;
  for (float reach_px = radius_px; reach_px < diagonal_px && levels < 16; reach_px *= 2.0f)
    ++levels;
  return levels;
}

}  // namespace

Pyramid HierarchicalFrame::pyramid_of_view(const View& view, Extent extent, int32_t light) {
  const GBuffer g = inputs_.host->render_view(public_frame_, view, extent, {.light = light});
  if (!g.depth.valid()) {
    frame_.fail({ErrorKind::usage, "the engine gives no G-buffer of other views"});
    return {};
  }
  Pyramid pyramid = begin_pyramid(view, g, {.factor = 1, .source = g.source});
  finish_pyramid(pyramid, levels_across(extent, settings_.radius));
  if (settings_.visibility != Settings::Visibility::none) voxelize(pyramid);
  return pyramid;
}

void HierarchicalFrame::gather_from(const Pyramid& givers, const Pyramid& receivers,
                                    const std::string& pass, Image indirect, bool is_first) {
  const Level& to = receivers.finest();
  const bool is_blocked = givers.voxel_range.valid();
  const uint32_t pixels_per_thread = gather_pixels_per_thread(to.extent, is_blocked);
  for (uint32_t k = 0; k < givers.levels.size(); ++k) {
    const Level& from = givers.levels[k];
    GatherViewParams params{};
    params.gather = gather_params(from, k, static_cast<uint32_t>(settings_.samples));
    params.gather.extent = as_ivec2(to.extent);
    params.receiver_screen = to.screen;
    params.source_from_receiver = givers.view_from_world * receivers.world_from_view;
    params.is_first = is_first && k == 0 ? 1 : 0;
    Dispatch dispatch{
        .shader = is_blocked ? shaders::techniques_hierarchical_gather_view_visible_comp
                             : shaders::techniques_hierarchical_gather_view_comp,
        .constants = {{"pixels_per_thread", pixels_per_thread},
                      {"form_factor", static_cast<uint32_t>(settings_.form_factor)}},
        .params = params,
        .read = {{"geometry", from.geometry}, {"source", from.source}, {"receivers", to.geometry}},
        .write = {{"indirect", indirect}},
        .over = {to.extent.width, 3 * divide_up(to.extent.height, 3 * pixels_per_thread)}};
    if (is_blocked) {
      check_rounds(params.gather, 2);
      dispatch.read.push_back({"voxels", givers.levels[voxel_level(k)].voxels});
      dispatch.read.push_back({"range", givers.voxel_range});
      dispatch.read.push_back({"receiver_voxels", receivers.finest().voxels});
      dispatch.read.push_back({"receiver_range", receivers.voxel_range});
    }
    frame_.dispatch(at_level(pass, k), dispatch);
  }
}

// The first bounce of all lights, from what each of them shines on.
Gathered HierarchicalFrame::gather_from_lights(const Pyramid& receivers) {
  const auto side_px = static_cast<uint32_t>(settings_.light_view_px);
  const Image indirect = frame_.image("indirect", receivers.finest().extent, Format::rgba16f);
  Gathered sum{indirect, 0};
  const std::span<const PunctualLight> lights = inputs_.host->lights();
  for (size_t i = 0; i < lights.size() && !frame_.failed(); ++i) {
    for (const View& view : views_of_light(lights[i], inputs_.host->bounds())) {
      const Pyramid givers = pyramid_of_view(view, {side_px, side_px}, static_cast<int32_t>(i));
      if (frame_.failed()) break;
      gather_from(givers, receivers, "gather_light", indirect, sum.levels == 0);
      sum.levels += static_cast<uint32_t>(givers.levels.size());
      release(givers);
    }
  }
  return sum;
}

// Beyond the paper: this view's receivers gather from the other's sources, whether that sees the
// receivers or not.
Image HierarchicalFrame::gather_from_side_view(const Pyramid& pyramid, const View& view) {
  const Extent extent = pyramid.finest().extent;
  const Pyramid givers = pyramid_of_view(view, extent, kAllLights);
  if (frame_.failed()) return {};
  const Image indirect = frame_.image("indirect", extent, Format::rgba16f);
  gather_from(givers, pyramid, "gather_side", indirect, true);
  release(givers);
  return filter(pyramid.finest(), 0, "side_", indirect);
}

// HSSIL 5: the other camera gathers for itself, and its light is warped to where it is seen here.
Image HierarchicalFrame::warp_from_side_view(const Pyramid& pyramid, const View& view,
                                             Image light) {
  const Level& here = pyramid.finest();
  const Pyramid there = pyramid_of_view(view, here.extent, kAllLights);
  if (frame_.failed()) return {};
  const Gathered gathered = gather_all_levels(there, true);
  const Image largest = frame_.image("largest", here.extent, Format::rgba16f);
  frame_.dispatch("hierarchical.side_warp",
                  {.shader = shaders::techniques_hierarchical_warp_view_comp,
                   .params = WarpViewParams{here.screen, there.finest().screen,
                                            there.view_from_world * pyramid.world_from_view,
                                            as_ivec2(here.extent)},
                   .read = {{"geometry", here.geometry},
                            {"light", light},
                            {"geometry_there", there.finest().geometry},
                            {"light_there", gathered.light}},
                   .write = {{"largest", largest}},
                   .over = here.extent});
  frame_.release(gathered.light);
  release(there);
  return largest;
}

Image HierarchicalFrame::with_side_views(const Pyramid& pyramid, Image light) {
  for (const View& view : inputs_.side_views) {
    Image both;
    if (settings_.side_views == Settings::SideViews::warp) {
      both = warp_from_side_view(pyramid, view, light);
    } else {
      const Image side = gather_from_side_view(pyramid, view);
      if (frame_.failed()) return {};
      both = add("hierarchical.side_max", pyramid.finest().extent, light, side, true);
      frame_.release(side);
    }
    if (frame_.failed()) return {};
    frame_.release(light);
    light = both;
  }
  return light;
}

}  // namespace lueur::hierarchical
