// SPDX-License-Identifier: MIT
// SOL 5, "more point lights results in higher image quality": how much of it, and what is left.
#include <algorithm>
#include <string>

#include "base/try.h"
#include "paper_sol_parts.h"
#include "reference_trace.h"
#include "statistics.h"

namespace lueur::cli::sol {
namespace {

constexpr uint32_t kCounts[] = {30, 100, 300, 1000, 2000};
// So many rays that their number counts for nothing beside what is blocked.
constexpr uint32_t kManyRays = 16384;
constexpr const char* kScenes[] = {"cornell", "floating-object", "atrium"};

Extent size_of_pictures(const PaperSetup& setup) {
  return {std::max(setup.picture_size.width / 8, 1u), std::max(setup.picture_size.height / 8, 1u)};
}

// The relative MSE against one bounce of `path`, by the number of lights as in kCounts.
struct Errors {
  std::vector<double> ours;
  std::vector<double> with_shadows;  // of the sum with shadow rays
  double of_many = 0.0;              // of the sum of kManyRays without them
};

Result<Errors> measure(Session& session, const PaperSetup& setup, const std::string& name) {
  LUEUR_TRY(loaded, load_scene(name));
  const Extent size = size_of_pictures(setup);
  const auto trace = [&](reference::Mode mode, uint32_t spp) {
    return trace_reference(loaded.scene, {size.width, size.height, 0, 0.0f},
                           {.mode = mode, .spp = spp}, std::string(reference::name_of(mode)),
                           setup.stop, setup.cache);
  };
  LUEUR_TRY(path, trace(reference::Mode::path, setup.spp));
  const Mask surfaces = mask_of(*find_layer(path.rendering, "depth"));
  const ImageF& truth = *find_layer(path.rendering, "indirect");
  const auto error_of = [&](reference::Mode mode, uint32_t rays) -> Result<double> {
    LUEUR_TRY(sum, trace(mode, rays));
    return sample_errors(*find_layer(sum.rendering, "indirect"), truth, &surfaces).rel_mse;
  };

  Errors errors;
  std::vector<LightSettings> settings;
  for (const uint32_t count : kCounts) {
    LUEUR_TRY(error, error_of(reference::Mode::lights, count));
    errors.with_shadows.push_back(error);
    settings.push_back(lights(count, 0, {"low_resolution=none"}));
    if (setup.stop.stop_requested()) return errors;
  }
  LUEUR_TRY(of_many, error_of(reference::Mode::lights_unoccluded, kManyRays));
  errors.of_many = of_many;
  LUEUR_TRY(candidates, light_candidates(session, setup, name, size, settings));
  LUEUR_TRY(ours, errors_of(session, candidates, truth, surfaces));
  for (const SampleErrors& one : ours) errors.ours.push_back(one.rel_mse);
  return errors;
}

report::Cell exponent_of(const std::vector<double>& errors) {
  const std::vector<double> x(std::begin(kCounts), std::end(kCounts));
  const auto law = fit_power_law(x, errors);
  return law ? report::Cell(law->exponent) : report::Cell();
}

}  // namespace

Result<std::vector<report::Block>> errors_by_lights(Session& session, const PaperSetup& setup) {
  report::Table table{"Relative MSE against one bounce of path, without negative lights",
                      {{"lights", "", "", 3}},
                      {}};
  for (const uint32_t count : kCounts) table.rows.push_back({std::to_string(count)});
  table.rows.push_back({std::to_string(kManyRays)});
  table.rows.push_back({"exponent of the first five"});
  for (const char* scene : kScenes) {
    LUEUR_TRY(errors, measure(session, setup, scene));
    if (setup.stop.stop_requested()) return std::vector<report::Block>{};
    table.columns.push_back({"ours", "", scene, 3});
    table.columns.push_back({"with shadow rays", "", scene, 3});
    for (size_t i = 0; i < std::size(kCounts); ++i) {
      table.rows[i].emplace_back(errors.ours[i]);
      table.rows[i].emplace_back(errors.with_shadows[i]);
    }
    auto& of_many = table.rows[std::size(kCounts)];
    of_many.emplace_back(errors.of_many);
    of_many.emplace_back();
    table.rows.back().push_back(exponent_of(errors.ours));
    table.rows.back().push_back(exponent_of(errors.with_shadows));
  }
  const Extent size = size_of_pictures(setup);
  return std::vector<report::Block>{
      table, report::Paragraph{"At " + std::to_string(size.width) + " x " +
                               std::to_string(size.height) + ", " + std::to_string(setup.spp) +
                               " samples of path. What shadow rays leave is what the number of "
                               "lights is off by; the sum of very many lights that nothing blocks "
                               "tells what missing shadows are off by."}};
}

}  // namespace lueur::cli::sol
