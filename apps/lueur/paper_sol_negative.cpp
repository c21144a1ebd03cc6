// SPDX-License-Identifier: MIT
// SOL's figures 5 and 6: what negative lights take away, and what they are off by.
#include <algorithm>
#include <string>

#include "base/try.h"
#include "paper_sol_parts.h"
#include "reference_trace.h"

namespace lueur::cli::sol {
namespace {

// What a setting is off by, against the sum over the same lights with shadow rays.
Result<report::Table> error_table(Session& session, const PaperSetup& setup) {
  report::Table table{"Off by, against the sum with shadow rays for as many lights", {}, {}};
  table.columns = {{"", "", "", 3}};
  for (const char* group : {"relative MSE", "bias"})
    for (const char* heading : {"300, 0", "300, 150", "300, 600"})
      table.columns.push_back({heading, "", group, 3});
  const Extent size{std::max(setup.picture_size.width / 4, 1u),
                    std::max(setup.picture_size.height / 4, 1u)};
  for (const char* scene : {"floating-object", "still-life", "cornell"}) {
    LUEUR_TRY(loaded, load_scene(scene));
    LUEUR_TRY(truth, trace_reference(loaded.scene, {size.width, size.height, 0, 0.0f},
                                     {.mode = reference::Mode::lights, .spp = 300}, "lights",
                                     setup.stop, setup.cache));
    if (setup.stop.stop_requested()) return table;
    const Mask surfaces = mask_of(*find_layer(truth.rendering, "depth"));
    LUEUR_TRY(candidates, light_candidates(session, setup, scene, size,
                                           {lights(300, 0), lights(300, 150), lights(300, 600)}));
    LUEUR_TRY(errors,
              errors_of(session, candidates, *find_layer(truth.rendering, "indirect"), surfaces));
    std::vector<report::Cell> row = {scene};
    for (const SampleErrors& found : errors) row.emplace_back(found.rel_mse);
    for (const SampleErrors& found : errors) row.emplace_back(found.bias);
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

Result<report::FigureSection> negative_lights(Session& session, const PaperSetup& setup) {
  LUEUR_TRY(candidates, light_candidates(session, setup, kScene, setup.picture_size,
                                         {lights(300, 0, {"low_resolution=none"}),
                                          lights(300, 150, {"low_resolution=none"})}));
  const float exposure_ev = candidates.front().scene->exposure_ev;
  report::PictureRow pictures{{}, "Figures 5 and 6: 300 lights, 150 negative ones."};
  ImageF open;
  LUEUR_TRY(without, show(session, candidates[0]));
  LUEUR_TRY(with, show(session, candidates[1]));
  const auto add = [&](Image8 picture, const char* caption) {
    pictures.pictures.push_back({std::move(picture), caption, {}});
  };
  add(shown(without.light, exposure_ev, 1.0f), "The lights, before albedo, a stop brighter");
  add(std::move(without.composed), "Without");
  add(shown(with.light, exposure_ev, 1.0f), "And the negative ones");
  add(shown(taken_away(without.light, with.light), exposure_ev, 3.0f),
      "What these take away, four times as bright");
  add(std::move(with.composed), "With negative lights");
  LUEUR_TRY(table, error_table(session, setup));
  if (setup.stop.stop_requested()) return report::FigureSection{};
  report::FigureSection section;
  section.blocks = {
      pictures, table,
      report::Paragraph{
          "The paper shows what negative lights change, without numbers. The sums are over lights "
          "that exact rays place, in the same directions, at a quarter of the pictures' size."}};
  return section;
}

}  // namespace lueur::cli::sol
