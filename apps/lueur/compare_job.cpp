// SPDX-License-Identifier: MIT
#include "compare_job.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "arguments.h"
#include "base/check.h"
#include "base/try.h"
#include "comparison_pictures.h"
#include "console.h"
#include "interrupt.h"
#include "json_output.h"
#include "picture.h"
#include "reference_trace.h"
#include "report/results.h"
#include "timing.h"

namespace lueur::cli {
namespace {

using Traced = std::vector<reference::CachedRendering>;

// All references in the order of the job; where interrupted, the last is not complete.
Result<Traced> trace(const CompareJob& job, const Scene& scene, int32_t camera) {
  const InterruptWatch watch;
  const reference::Shot shot{job.setup.size.width, job.setup.size.height, camera, 0.0f};
  Traced all;
  for (const ChosenReference& chosen : job.references) {
    reference::Settings settings = chosen.settings;
    settings.seed = job.setup.seed;
    LUEUR_TRY(traced,
              trace_reference(scene, shot, settings, chosen.label, watch.token(), job.cache));
    all.push_back(std::move(traced));
    if (!all.back().rendering.complete) break;
  }
  return all;
}

Result<std::vector<Candidate>> candidates_of(const CompareJob& job, Session& session) {
  std::vector<CandidateRequest> requests;
  for (const ChosenTechnique& technique : job.techniques)
    requests.push_back({technique.label, job.scene, job.setup.size, copy(technique),
                        job.setup.environment, job.limits});
  return make_candidates(session, std::move(requests), job.frame.camera, job.setup.seed,
                         job.frame.side_cameras);
}

// What is known before anything is rendered.
report::Comparison comparison_of(const CompareJob& job, const Scene& scene, int32_t camera,
                                 const Traced& traced) {
  report::Comparison comparison;
  comparison.title = scene.name + ": indirect light";
  comparison.scene = job.scene;
  comparison.camera = scene.cameras[static_cast<size_t>(camera)].name;
  comparison.width = job.setup.size.width;
  comparison.height = job.setup.size.height;
  comparison.command = job.command;
  comparison.metrics = comparison_metrics();
  for (const reference::CachedRendering& one : traced)
    if (!one.cache_note.empty()) comparison.warnings.push_back(one.cache_note);
  comparison.warnings.insert(comparison.warnings.end(), scene.warnings.begin(),
                             scene.warnings.end());
  return comparison;
}

report::Reference reference_of(const ChosenReference& chosen, const reference::Rendering& rendering,
                               std::span<const Pixels> pixels) {
  report::Reference truth;
  truth.label = chosen.label;
  truth.mode = std::string(name_of(chosen.settings.mode));
  truth.samples_per_pixel = rendering.progress.spp_done;
  if (std::isfinite(rendering.progress.relative_error))
    truth.relative_error = rendering.progress.relative_error;
  truth.seconds = rendering.progress.seconds;
  truth.pictures = pictures_of(rendering, pixels);
  return truth;
}

report::Entry entry_of(const Candidate& candidate, const Summary& summary,
                       std::span<const Pixels> pixels) {
  report::Entry entry;
  entry.label = candidate.label;
  entry.technique = candidate.technique.name();
  entry.settings = settings_json(candidate.technique.info, candidate.technique.technique.get());
  entry.technique_ms = rounded_ms(summary.technique_ms.median);
  entry.frame_ms = rounded_ms(summary.frame_ms.median);
  for (const PassSummary& pass : summary.passes)
    if (owner_of(pass.name, candidate.technique) != PassOwner::host)
      entry.passes.push_back({pass.name, rounded_ms(pass.gpu_ms.median)});
  entry.pictures = pictures_of(pixels);
  return entry;
}

// Renders each technique once more, for its pictures, and holds it against the references, whose
// pictures share direct light and albedo with the first frame, as they are those of every one.
Result<void> compare(const CompareJob& job, const Scene& scene, const Traced& traced,
                     Session& session, std::vector<Candidate>& candidates,
                     const std::vector<Summary>& summaries, report::Comparison& comparison) {
  Mask surfaces;
  for (size_t i = 0; i < candidates.size(); ++i) {
    print_progress("comparing " + candidates[i].label);
    LUEUR_TRY(frame, render_candidate(session, candidates[i], kAllImages));
    if (i == 0) {
      comparison.direct = direct_of(frame.pixels);
      surfaces = mask_of(as_image(*find_pixels(frame.pixels, "depth"), 1));
      for (size_t r = 0; r < traced.size(); ++r)
        comparison.references.push_back(
            reference_of(job.references[r], traced[r].rendering, frame.pixels));
    }
    report::Entry entry = entry_of(candidates[i], summaries[i], frame.pixels);
    for (const report::Reference& truth : comparison.references) {
      LUEUR_TRY(errors, errors_between(entry.pictures, truth.pictures, truth.label, surfaces));
      if (!errors.values.empty()) entry.errors.push_back(std::move(errors));
    }
    comparison.entries.push_back(std::move(entry));
  }
  const auto lit =
      std::ranges::find_if(comparison.references, [](const report::Reference& reference) {
        return !reference.pictures.composed.samples.empty();
      });
  const ImageF& metered =
      lit == comparison.references.end() ? comparison.direct : lit->pictures.composed;
  comparison.exposure_ev = static_cast<double>(exposure_ev({}, scene.exposure_ev, metered));
  return {};
}

// A column of the printed table.
struct Column {
  std::string_view metric;
  const char* heading;
  const char* second_line;
  const char* format;
};
constexpr Column kColumns[] = {{"flip", "flip", "", "%10.4f"},
                               {"bias", "bias", "", "%+10.4f"},
                               {"indirect_bias", "indirect", "bias", "%+10.4f"},
                               {"indirect_rel_mse", "indirect", "rel mse", "%10.4f"},
                               {"occlusion_rmse", "occlusion", "rmse", "%10.4f"},
                               {"occlusion_bias", "occlusion", "bias", "%+10.4f"}};

const report::ErrorValue* find_value(const report::Errors& errors, std::string_view metric) {
  const auto found = std::ranges::find(errors.values, metric, &report::ErrorValue::metric);
  return found == errors.values.end() ? nullptr : &*found;
}

// Those of which there is a number.
std::vector<Column> columns_of(const report::Comparison& comparison) {
  std::vector<Column> columns;
  for (const Column& column : kColumns) {
    const bool used = std::ranges::any_of(comparison.entries, [&](const report::Entry& entry) {
      return std::ranges::any_of(entry.errors, [&](const report::Errors& errors) {
        return find_value(errors, column.metric) != nullptr;
      });
    });
    if (used) columns.push_back(column);
  }
  return columns;
}

std::string text_of(const report::Comparison& comparison) {
  const std::vector<Column> columns = columns_of(comparison);
  char cell[256];
  std::string text;
  const auto add = [&](const char* format, auto... values) {
    std::snprintf(cell, sizeof(cell), format, values...);
    text += cell;
  };
  const auto add_row = [&](const report::Entry& entry, const report::Errors* errors) {
    add("%-36s %-20s %9.2f", printable(entry.label).c_str(),
        errors ? printable(errors->reference).c_str() : "-", entry.technique_ms);
    for (const Column& column : columns) {
      const report::ErrorValue* value = errors ? find_value(*errors, column.metric) : nullptr;
      if (value)
        add(column.format, value->value);
      else
        add("%10s", "-");
    }
    text += "\n";
  };

  add("%-36s %-20s %9s", "technique", "reference", "ms");
  for (const Column& column : columns) add("%10s", column.heading);
  text += "\n";
  add("%-36s %-20s %9s", "", "", "");
  for (const Column& column : columns) add("%10s", column.second_line);
  text += "\n";
  for (const report::Entry& entry : comparison.entries) {
    for (const report::Errors& errors : entry.errors) add_row(entry, &errors);
    if (entry.errors.empty()) add_row(entry, nullptr);
  }
  return text;
}

}  // namespace

Outcome run_compare(CompareJob& job) {
  print_progress("loading " + job.scene);
  LUEUR_TRY(loaded, load_scene(job.scene, job.setup.environment, job.limits));
  const Scene& scene = loaded.scene;
  LUEUR_TRY(camera, find_camera(scene, job.frame.camera));
  // Before the device is opened, whose threads would take the signals.
  LUEUR_TRY(traced, trace(job, scene, camera));
  if (!traced.empty() && !traced.back().rendering.complete) {
    print_warning("interrupted; nothing was written");
    return kExitInterrupted;
  }

  LUEUR_TRY(session, open_session({.device = job.frame.device}));
  LUEUR_TRY(candidates, candidates_of(job, session));
  print_progress("timing on " + session.system->device().name);
  LUEUR_TRY(rounds, time_in_turn(session, candidates, job.frames));

  report::Comparison comparison = comparison_of(job, scene, camera, traced);
  comparison.device = session.system->device().name;
  LUEUR_TRY_VOID(
      compare(job, scene, traced, session, candidates, summarize(rounds, candidates), comparison));
  LUEUR_TRY_VOID(report::write_comparison(comparison, job.folder));
  print_progress("wrote " + (job.folder / "index.html").string());
  LUEUR_TRY_VOID(job.json ? print_json(report::results_json(comparison))
                          : print_data(text_of(comparison)));
  return kExitDone;
}

}  // namespace lueur::cli
