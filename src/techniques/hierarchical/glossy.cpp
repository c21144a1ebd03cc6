// SPDX-License-Identifier: MIT
#include "techniques/hierarchical/hierarchical_frame.h"
#include "techniques/hierarchical/shaders.h"
#include "techniques/lobe_data.h"

namespace lueur::hierarchical {

HierarchicalFrame::Lobes HierarchicalFrame::lobes_of(const Pyramid& pyramid) {
  const GBuffer& g = pyramid.g_buffer;
  const Level& level = pyramid.finest();
  const Lobes lobes{frame_.image("lobe", level.extent, Format::r16f),
                    frame_.upload(lobe_data(inputs_.lobes))};
  frame_.dispatch(
      "hierarchical.lobe",
      {.shader = shaders::techniques_hierarchical_lobe_comp,
       .constants = {{"factor", static_cast<uint32_t>(pyramid.factor)}},
       .params = LobeParams{pyramid.screen, as_ivec2(g.depth.extent), as_ivec2(level.extent)},
       .read = {{"depth", g.depth}, {"reflectance", g.reflectance}, {"geometry", level.geometry}},
       .write = {{"lobe", lobes.codes}},
       .over = level.extent});
  return lobes;
}

Gathered HierarchicalFrame::gather_glossy(const Pyramid& pyramid, const Lobes& lobes) {
  return gather_levels(pyramid, "glossy_", [&](const Level& level, uint32_t k) {
    const Image glossy = frame_.image("glossy", level.extent, Format::rgba16f);
    const bool blocked = pyramid.voxel_range.valid();
    const GatherParams params =
        gather_params(level, k, static_cast<uint32_t>(settings_.glossy_samples));
    Dispatch dispatch{.shader = blocked
                                    ? shaders::techniques_hierarchical_gather_glossy_visible_comp
                                    : shaders::techniques_hierarchical_gather_glossy_comp,
                      .constants = {{"importance", settings_.glossy_importance ? 1u : 0u}},
                      .params = params,
                      .read = {{"geometry", level.geometry},
                               {"source", level.source},
                               {"lobe", lobes.codes},
                               {"lobes", lobes.table}},
                      .write = {{"glossy", glossy}},
                      .over = level.extent};
    if (blocked) {
      dispatch.read.push_back({"voxels", pyramid.levels[voxel_level(k)].voxels});
      dispatch.read.push_back({"range", pyramid.voxel_range});
    }
    frame_.dispatch(at_level("glossy_gather", k), dispatch);
    return glossy;
  });
}

Image HierarchicalFrame::output_glossy(const Pyramid& pyramid, const Gathered& gathered) {
  const GBuffer& g = pyramid.g_buffer;
  const Image specular = frame_.image("specular", g.depth.extent, Format::rgba16f);
  frame_.dispatch("hierarchical.glossy_output",
                  {.shader = shaders::techniques_hierarchical_output_glossy_comp,
                   .constants = {{"factor", static_cast<uint32_t>(pyramid.factor)}},
                   .params = output_params(pyramid, gathered),
                   .read = {{"geometry", pyramid.finest().geometry},
                            {"light", gathered.light},
                            {"depth", g.depth},
                            {"normal", g.normal},
                            {"reflectance", g.reflectance}},
                   .write = {{"specular", specular}},
                   .over = corners_of(pyramid.finest().extent)});
  return specular;
}

// Glossy lobes see what the camera sees: its sources, and what those reflect of all bounces but the
// last.
Pyramid HierarchicalFrame::pyramid_of_glossy_sources(const Pyramid& pyramid, Image albedo,
                                                     Image light) {
  Pyramid lit = pyramid;
  const bool by_lights = settings_.sources == Settings::Sources::lights;
  if (by_lights) {
    const Pyramid direct =
        begin_pyramid(inputs_.view, pyramid.g_buffer,
                      {.factor = pyramid.factor, .source = pyramid.g_buffer.source});
    frame_.release(direct.finest().geometry);
    lit = with_source(pyramid, direct.finest().source);
  }
  if (!light.valid()) return lit;
  const Pyramid more = with_source(pyramid, reflect(lit, albedo, light, true));
  if (by_lights) release_sources(lit);
  return more;
}

Image HierarchicalFrame::glossy(const Pyramid& pyramid, Image albedo, const Gathered& diffuse) {
  const Pyramid lit = pyramid_of_glossy_sources(pyramid, albedo, diffuse.but_last);
  const Lobes lobes = lobes_of(pyramid);
  Gathered gathered = gather_glossy(lit, lobes);
  if (lit.finest().source.index != pyramid.finest().source.index) release_sources(lit);
  if (has_history()) {
    const Warped before = warp(pyramid, "glossy", &lobes);
    const Image now = blend(pyramid, "glossy", before, gathered.light);
    frame_.release(before.light);
    frame_.release(gathered.light);
    gathered.light = now;
  }
  const Image specular = output_glossy(pyramid, gathered);
  frame_.release(gathered.light);
  frame_.release(lobes.codes);
  return specular;
}

}  // namespace lueur::hierarchical
