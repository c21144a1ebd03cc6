// SPDX-License-Identifier: MIT
#include "compare_job.h"

#include <cmath>
#include <cstdio>

#include "base/try.h"
#include "comparison_pictures.h"
#include "console.h"
#include "image/exposure.h"
#include "interrupt.h"
#include "json_output.h"
#include "picture.h"
#include "reference_job.h"
#include "report/results.h"
#include "timing.h"

namespace lueur::cli {
namespace {

// Traces all references; false when interrupted.
Result<bool> trace(const CompareJob& job, const Scene& scene, int32_t camera,
                   const std::stop_token& stop, std::vector<reference::Rendering>& renderings,
                   std::vector<std::string>& warnings) {
  for (const ChosenReference& chosen : job.references) {
    reference::Settings settings = chosen.settings;
    settings.seed = job.setup.seed;
    const reference::Shot shot{job.setup.size.width, job.setup.size.height, camera, 0.0f};
    const reference::Control control{
        .progress =
            [&](const reference::Progress& p) {
              print_progress("tracing " + chosen.label + ": " + describe(p));
            },
        .stop = stop,
        .checkpoint = {}};
    LUEUR_TRY(traced, reference::render_cached(scene, shot, settings, control, {}, job.cache));
    if (!traced.cache_note.empty()) warnings.push_back(traced.cache_note);
    renderings.push_back(std::move(traced.rendering));
    if (!renderings.back().complete) return false;
  }
  return true;
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
    if (pass.name.starts_with(entry.technique + "."))
      entry.passes.push_back({pass.name, rounded_ms(pass.gpu_ms.median)});
  entry.pictures = pictures_of(pixels);
  return entry;
}

std::string text_of(const report::Comparison& comparison) {
  const auto column = [](const report::Errors& errors, std::string_view metric) {
    for (const report::ErrorValue& value : errors.values)
      if (value.metric == metric) return value.value;
    return 0.0;
  };
  char line[256];
  std::string text;
  std::snprintf(line, sizeof(line), "%-36s %-20s %9s %7s %8s %9s %9s\n", "technique", "reference",
                "ms", "flip", "bias", "indirect", "indirect");
  text += line;
  std::snprintf(line, sizeof(line), "%-36s %-20s %9s %7s %8s %9s %9s\n", "", "", "", "", "", "bias",
                "rel mse");
  text += line;
  for (const report::Entry& entry : comparison.entries) {
    for (const report::Errors& errors : entry.errors) {
      std::snprintf(line, sizeof(line), "%-36s %-20s %9.2f %7.4f %+8.4f %+9.4f %9.4f\n",
                    printable(entry.label).c_str(), printable(errors.reference).c_str(),
                    entry.technique_ms, column(errors, "flip"), column(errors, "bias"),
                    column(errors, "indirect_bias"), column(errors, "indirect_rel_mse"));
      text += line;
    }
    if (entry.errors.empty()) {
      std::snprintf(line, sizeof(line), "%-36s %-20s %9.2f\n", printable(entry.label).c_str(), "-",
                    entry.technique_ms);
      text += line;
    }
  }
  return text;
}

}  // namespace

Outcome run_compare(CompareJob& job) {
  print_progress("loading " + job.scene);
  LUEUR_TRY(loaded, load_scene(job.scene));
  const Scene& scene = loaded.scene;
  LUEUR_TRY(camera, find_camera(scene, job.frame.camera));

  report::Comparison comparison;
  std::vector<reference::Rendering> truths;
  {
    const InterruptWatch watch;
    LUEUR_TRY(whole, trace(job, scene, camera, watch.token(), truths, comparison.warnings));
    if (!whole) {
      print_warning("interrupted; nothing was written");
      return kExitInterrupted;
    }
  }

  LUEUR_TRY(session, open_session({.device = job.frame.device}));
  std::vector<CandidateRequest> requests;
  for (const ChosenTechnique& technique : job.techniques)
    requests.push_back({technique.label, job.scene, job.setup.size, copy(technique)});
  LUEUR_TRY(candidates,
            make_candidates(session, std::move(requests), job.frame.camera, job.setup.seed));
  print_progress("timing on " + session.system->device().name);
  LUEUR_TRY(rounds, time_in_turn(session, candidates, job.frames));
  const std::vector<Summary> summaries = summarize(rounds, candidates);

  comparison.title = scene.name + ": indirect light";
  comparison.scene = job.scene;
  comparison.camera = scene.cameras[static_cast<size_t>(camera)].name;
  comparison.width = job.setup.size.width;
  comparison.height = job.setup.size.height;
  comparison.device = session.system->device().name;
  comparison.command = job.command;
  comparison.metrics = comparison_metrics();
  comparison.warnings.insert(comparison.warnings.end(), scene.warnings.begin(),
                             scene.warnings.end());
  Mask surfaces;
  for (size_t i = 0; i < candidates.size(); ++i) {
    print_progress("comparing " + candidates[i].label);
    LUEUR_TRY(frame, render_candidate(session, candidates[i], kAllImages));
    if (i == 0) {
      // Direct light and surfaces are those of every technique's frame.
      comparison.direct = direct_of(frame.pixels);
      surfaces = mask_of(as_image(*find_pixels(frame.pixels, "depth"), 1));
      for (size_t r = 0; r < truths.size(); ++r) {
        const reference::Progress& progress = truths[r].progress;
        report::Reference truth{
            job.references[r].label, std::string(name_of(job.references[r].settings.mode)),
            progress.spp_done,       std::nullopt,
            progress.seconds,        pictures_of(truths[r], frame.pixels)};
        if (std::isfinite(progress.relative_error)) truth.relative_error = progress.relative_error;
        comparison.references.push_back(std::move(truth));
      }
      comparison.exposure_ev = static_cast<double>(scene.exposure_ev.value_or(auto_exposure_ev(
          truths.empty() ? comparison.direct : comparison.references[0].pictures.composed)));
    }
    report::Entry entry = entry_of(candidates[i], summaries[i], frame.pixels);
    for (const report::Reference& truth : comparison.references) {
      LUEUR_TRY(errors, errors_between(entry.pictures, truth.pictures, truth.label, surfaces));
      entry.errors.push_back(std::move(errors));
    }
    comparison.entries.push_back(std::move(entry));
  }

  LUEUR_TRY_VOID(report::write_comparison(comparison, job.folder));
  print_progress("wrote " + (job.folder / "index.html").string());
  LUEUR_TRY_VOID(job.json ? print_json(report::results_json(comparison))
                          : print_data(text_of(comparison)));
  return kExitDone;
}

}  // namespace lueur::cli
