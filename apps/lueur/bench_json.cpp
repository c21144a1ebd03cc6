// SPDX-License-Identifier: MIT
#include <algorithm>

#include "bench_report.h"

namespace lueur::cli {
namespace {

// Puts `key` and `key`_spread.
void put(Json& json, const std::string& key, const Distribution& ms) {
  json[key] = rounded_ms(ms.median);
  json[key + "_spread"] = {{"least", rounded_ms(ms.least)},
                           {"lower_quartile", rounded_ms(ms.lower_quartile)},
                           {"upper_quartile", rounded_ms(ms.upper_quartile)},
                           {"most", rounded_ms(ms.most)}};
}

Json or_null(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json pass_json(const PassSummary& pass) {
  Json json = {{"name", pass.name}};
  put(json, "gpu_ms", pass.gpu_ms);
  json["cpu_ms"] = rounded_ms(pass.cpu_ms);
  if (pass.samples) {
    json["samples"] = *pass.samples;
    json["cpu_ns_per_sample"] = pass.cpu_ms * 1e6 / static_cast<double>(*pass.samples);
  }
  return json;
}

Json run_json(const Candidate& candidate, const Summary& summary) {
  const ChosenTechnique& technique = candidate.technique;
  Json json = {{"label", candidate.label},
               {"scene", candidate.scene->name},
               {"triangles", candidate.scene->triangles},
               {"size", size_json(candidate.shot.extent)},
               {"technique", technique.name()},
               {"settings", settings_json(technique.info, technique.technique.get())}};
  put(json, "technique_ms", summary.technique_ms);
  json["technique_cpu_ms"] = rounded_ms(summary.technique_cpu_ms);
  put(json, "host_ms", summary.host_ms);
  put(json, "frame_ms", summary.frame_ms);
  put(json, "wall_ms", summary.wall_ms);
  put(json, "cpu_ms", summary.cpu_ms);
  json["technique_memory_bytes"] = candidate.memory.technique;
  json["memory_bytes"] = candidate.memory.total;
  json["passes"] = Json::array();
  for (const PassSummary& pass : summary.passes) json["passes"].push_back(pass_json(pass));
  json["groups"] = Json::array();
  for (const PassSummary& group : summary.groups) json["groups"].push_back(pass_json(group));
  return json;
}

Json fit_json(const ScaleFit& fit) {
  Json json = {{"group", fit.group}};
  if (fit.power) {
    json["exponent"] = fit.power->exponent;
    json["exponent_error"] = or_null(fit.power->exponent_error);
    json["r_squared"] = or_null(fit.power->r_squared);
  }
  if (fit.line) {
    json["constant_ms"] = fit.line->constant;
    json["ms_per_unit"] = fit.line->slope;
    json["line_r_squared"] = or_null(fit.line->r_squared);
  }
  return json;
}

Json scale_json(const BenchReport& report) {
  Json series = Json::array();
  for (const Series& one : report.series) {
    Json fits = Json::array();
    for (const ScaleFit& fit : one.fits) fits.push_back(fit_json(fit));
    series.push_back({{"technique", one.technique},
                      {"first_run", one.first},
                      {"values", one.x},
                      {"fits", std::move(fits)}});
  }
  return {{"of", report.scale->of}, {"series", std::move(series)}};
}

// Whether `of` gives the same for all candidates.
template <class Of>
bool all_same(const std::vector<Candidate>& candidates, Of of) {
  return std::all_of(candidates.begin(), candidates.end(),
                     [&](const Candidate& c) { return of(c) == of(candidates.front()); });
}

}  // namespace

Json bench_json(const BenchReport& report) {
  const std::vector<Candidate>& candidates = report.candidates;
  const ChosenTechnique& technique = candidates.front().technique;
  Json json = {{"version", LUEUR_VERSION}, {"device", device_json(report.device)}};
  // What differs between the runs stands there alone.
  if (all_same(candidates, [](const Candidate& c) { return c.shot.extent; }))
    json["size"] = size_json(candidates.front().shot.extent);
  if (all_same(candidates, [](const Candidate& c) { return c.technique.label; })) {
    json["technique"] = technique.name();
    json["settings"] = settings_json(technique.info, technique.technique.get());
  }
  json["environment"] = environment_json(report.setup.environment);
  json["seed"] = report.setup.seed;
  json["frames"] = report.frames;
  json["warm_up_frames"] = warm_up_frames(report.frames);
  json["memory_bytes"] = report.memory.total_bytes;
  json["peak_memory_bytes"] = report.memory.peak_bytes;
  if (candidates.size() == 1) {
    json.update(run_json(candidates.front(), report.summaries.front()));
    return json;
  }
  json["runs"] = Json::array();
  for (size_t i = 0; i < candidates.size(); ++i) {
    Json run = run_json(candidates[i], report.summaries[i]);
    run["technique_ratio"] = or_null(report.summaries[i].technique_ratio);
    run["frame_ratio"] = or_null(report.summaries[i].frame_ratio);
    json["runs"].push_back(std::move(run));
  }
  json["technique_ms_max_over_min"] = max_over_min(report.summaries);
  if (report.scale) json["scale"] = scale_json(report);
  return json;
}

double max_over_min(const std::vector<Summary>& summaries) {
  double least_ms = 0, most_ms = 0;
  for (const Summary& summary : summaries) {
    const double ms = summary.technique_ms.median;
    if (!(ms > 0.0)) continue;
    least_ms = least_ms > 0.0 ? std::min(least_ms, ms) : ms;
    most_ms = std::max(most_ms, ms);
  }
  return least_ms > 0.0 ? most_ms / least_ms : 1.0;
}

}  // namespace lueur::cli
