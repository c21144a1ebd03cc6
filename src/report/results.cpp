// SPDX-License-Identifier: MIT
#include "report/results.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/check.h"
#include "report/text.h"

namespace lueur::report {
namespace {

std::string_view better_name(Better better) {
  switch (better) {
    case Better::lower:
      return "lower";
    case Better::higher:
      return "higher";
    case Better::nearer_zero:
      return "nearer_zero";
  }
  LUEUR_CHECK(false);
  return {};
}

std::string_view tone_map_name(ToneMap tone_map) {
  const auto* const row = std::ranges::find(kToneMapNames, tone_map, &ToneMapName::tone_map);
  LUEUR_CHECK(row != kToneMapNames.end());
  return row->name;
}

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json metric_json(const Metric& metric) {
  return {{"name", metric.name},
          {"label", metric.label},
          {"unit", metric.unit},
          {"better", better_name(metric.better)},
          {"summary", metric.summary}};
}

Json reference_json(const Reference& reference) {
  return {{"label", reference.label},
          {"mode", reference.mode},
          {"samples_per_pixel", reference.samples_per_pixel},
          {"relative_error",
           reference.relative_error ? number(*reference.relative_error) : Json(nullptr)},
          {"seconds", number(reference.seconds)}};
}

Json entry_json(const Entry& entry) {
  Json passes = Json::array();
  for (const Pass& pass : entry.passes)
    passes.push_back({{"name", pass.name}, {"ms", number(pass.ms)}});
  Json errors = Json::object();
  for (const Errors& against : entry.errors) {
    Json& values = errors[against.reference] = Json::object();
    for (const ErrorValue& error : against.values) values[error.metric] = number(error.value);
  }
  return {{"label", entry.label},
          {"technique", entry.technique},
          {"settings", entry.settings},
          {"technique_ms", number(entry.technique_ms)},
          {"frame_ms", number(entry.frame_ms)},
          {"errors", std::move(errors)},
          {"passes", std::move(passes)}};
}

// The shortest text that reads back as the same number.
std::string csv_number(double value) {
  if (!std::isfinite(value)) return {};
  char text[32];
  return {text, std::to_chars(text, text + sizeof(text), value).ptr};
}

std::string csv_text(std::string_view text) {
  std::string clean = valid_utf8(text);
  if (clean.find_first_of(",\"\r\n") == std::string::npos) return clean;
  std::string quoted = "\"";
  for (const char c : clean) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

std::string csv_row(const Comparison& comparison, const Entry& entry, const Errors& against) {
  std::string row = csv_text(entry.label) + ',' + csv_text(entry.technique) + ',' +
                    csv_text(against.reference) + ',' + csv_number(entry.technique_ms) + ',' +
                    csv_number(entry.frame_ms);
  for (const Metric& metric : comparison.metrics) {
    row += ',';
    const auto found = std::ranges::find(against.values, metric.name, &ErrorValue::metric);
    if (found != against.values.end()) row += csv_number(found->value);
  }
  return row + '\n';
}

}  // namespace

std::vector<Metric> standard_metrics() {
  return {
      {"rmse", "RMSE", "radiance", Better::lower,
       "Root of the mean squared difference of linear light."},
      {"rel_mse", "relMSE", "", Better::lower,
       "Mean squared difference of linear light over the squared reference."},
      {"psnr", "PSNR", "dB", Better::higher,
       "Peak signal-to-noise ratio of the displayed picture."},
      {"ssim", "SSIM", "", Better::higher,
       "Structural similarity of the displayed picture: 1 for equal pictures."},
      {"flip", "FLIP", "", Better::lower,
       "Mean difference as seen when flipping between the displayed pictures, 0 to 1."},
      {"bias", "bias", "", Better::nearer_zero,
       "Mean signed difference of linear light over the reference's mean: above 0 the technique is "
       "too bright."},
      {"rmse_scaled", "RMSE scaled", "radiance", Better::lower,
       "RMSE after the best common factor for brightness: the error of shape that is left."},
  };
}

Json results_json(const Comparison& comparison) {
  Json metrics = Json::array();
  for (const Metric& metric : comparison.metrics) metrics.push_back(metric_json(metric));
  Json references = Json::array();
  for (const Reference& reference : comparison.references)
    references.push_back(reference_json(reference));
  Json entries = Json::array();
  for (const Entry& entry : comparison.entries) entries.push_back(entry_json(entry));
  return {{"title", comparison.title},
          {"scene", comparison.scene},
          {"camera", comparison.camera},
          {"size", {comparison.width, comparison.height}},
          {"device", comparison.device},
          {"exposure_ev", number(comparison.exposure_ev)},
          {"tone_map", tone_map_name(comparison.tone_map)},
          {"command", comparison.command},
          {"warnings", comparison.warnings},
          {"metrics", std::move(metrics)},
          {"references", std::move(references)},
          {"entries", std::move(entries)}};
}

std::string results_csv(const Comparison& comparison) {
  std::string csv = "label,technique,reference,technique_ms,frame_ms";
  for (const Metric& metric : comparison.metrics) csv += ',' + csv_text(metric.name);
  csv += '\n';
  for (const Entry& entry : comparison.entries) {
    if (entry.errors.empty()) csv += csv_row(comparison, entry, {});
    for (const Errors& against : entry.errors) csv += csv_row(comparison, entry, against);
  }
  return csv;
}

}  // namespace lueur::report
