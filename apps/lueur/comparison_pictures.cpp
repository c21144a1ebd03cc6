// SPDX-License-Identifier: MIT
#include "comparison_pictures.h"

#include <cmath>
#include <string_view>

#include "base/check.h"
#include "base/try.h"
#include "image/picture_error.h"
#include "image/sample_error.h"
#include "picture.h"

namespace lueur::cli {
namespace {

constexpr std::string_view kIndirectMetrics[] = {"rmse", "rel_mse", "bias", "rmse_scaled"};
// The relative error that a map shows brightest: half of the light.
constexpr double kFullRelativeError = 0.5;
// And of occlusion: half of what there can be.
constexpr double kFullOcclusionError = 0.5;

ImageF image_named(std::span<const Pixels> rendered, std::string_view name) {
  const Pixels* pixels = find_pixels(rendered, name);
  LUEUR_CHECK(pixels != nullptr);
  return as_image(*pixels, 3);
}

double value_of(const PictureErrors& errors, std::string_view metric) {
  for (const ErrorMetric& row : kErrorMetrics)
    if (row.name == metric) return errors.*row.value;
  LUEUR_CHECK(!"a metric that picture_error.h does not know");
  return 0.0;
}

// The standard metric `name` as one of a part of the picture.
report::Metric metric_of_part(const std::string& part, std::string_view name,
                              const std::string& summary) {
  for (report::Metric metric : report::standard_metrics()) {
    if (metric.name != name) continue;
    metric.name = part + "_" + metric.name;
    metric.label = part + " " + metric.label;
    metric.summary = summary + metric.summary;
    return metric;
  }
  LUEUR_CHECK(!"a metric that results.h does not know");
  return {};
}

Result<report::Errors> occlusion_errors(const ImageF& test, const ImageF& reference,
                                        const std::string& reference_label, const Mask& surfaces) {
  report::Errors errors{reference_label, {}, {}};
  if (test.samples.empty()) return errors;
  LUEUR_TRY_VOID(check_comparable(test, reference));
  const SampleErrors samples = sample_errors(test, reference, &surfaces);
  errors.values = {{"occlusion_rmse", samples.rmse}, {"occlusion_bias", samples.bias}};
  ImageF difference = test;
  for (size_t i = 0; i < difference.samples.size(); ++i)
    difference.samples[i] =
        surfaces.counts[i] ? std::abs(difference.samples[i] - reference.samples[i]) : 0.0f;
  errors.maps.push_back({"occlusion_rmse", std::move(difference), kFullOcclusionError});
  return errors;
}

}  // namespace

ImageF direct_of(std::span<const Pixels> rendered) {
  ImageF direct = image_named(rendered, "source");
  const ImageF specular = image_named(rendered, "specular");
  for (size_t i = 0; i < direct.samples.size(); ++i) direct.samples[i] += specular.samples[i];
  return direct;
}

report::Pictures pictures_of(const reference::Rendering& rendering,
                             std::span<const Pixels> rendered) {
  if (const ImageF* occlusion = find_layer(rendering, "occlusion")) return {{}, {}, *occlusion};
  report::Pictures pictures{direct_of(rendered), *find_layer(rendering, "indirect")};
  const ImageF albedo = image_named(rendered, "albedo");
  const ImageF* specular = find_layer(rendering, "indirect_specular");
  for (size_t i = 0; i < albedo.samples.size(); ++i) {
    pictures.composed.samples[i] += albedo.samples[i] * pictures.indirect.samples[i];
    if (specular) pictures.composed.samples[i] += specular->samples[i];
  }
  // Behind everything both show the same environment.
  const ImageF composed = image_named(rendered, "composed");
  const Pixels* depth = find_pixels(rendered, "depth");
  LUEUR_CHECK(depth != nullptr);
  for (size_t i = 0; i < composed.samples.size(); ++i)
    if (depth->samples[i / 3] == 0.0f) pictures.composed.samples[i] = composed.samples[i];
  return pictures;
}

report::Pictures pictures_of(std::span<const Pixels> rendered) {
  report::Pictures pictures{image_named(rendered, "composed"), {}};
  const Pixels* indirect = find_pixels(rendered, "indirect");
  pictures.indirect = indirect ? as_image(*indirect, 3)
                               : ImageF(pictures.composed.width, pictures.composed.height, 3);
  if (const Pixels* occlusion = find_pixels(rendered, "occlusion")) {
    pictures.occlusion = as_image(*occlusion, 1);
  } else if (!indirect && !find_pixels(rendered, "indirect_specular")) {
    pictures.occlusion = ImageF(pictures.composed.width, pictures.composed.height, 1);
    for (float& open : pictures.occlusion.samples) open = 1.0f;
  }
  return pictures;
}

std::vector<report::Metric> comparison_metrics() {
  std::vector<report::Metric> metrics = report::standard_metrics();
  for (const std::string_view name : kIndirectMetrics)
    metrics.push_back(
        metric_of_part("indirect", name, "The same of indirect light alone, E/π before albedo. "));
  metrics.push_back({"occlusion_rmse", "occlusion RMSE", "", report::Better::lower,
                     "Root of the mean squared difference of occlusion, 1 open, 0 closed."});
  metrics.push_back({"occlusion_bias", "occlusion bias", "", report::Better::nearer_zero,
                     "Mean signed difference of occlusion over the reference's mean: above 0 the "
                     "technique is too open."});
  return metrics;
}

Result<report::Errors> errors_between(const report::Pictures& test,
                                      const report::Pictures& reference,
                                      const std::string& reference_label, const Mask& surfaces) {
  if (!reference.occlusion.samples.empty())
    return occlusion_errors(test.occlusion, reference.occlusion, reference_label, surfaces);
  LUEUR_TRY(composed, scene_errors(test.composed, reference.composed, &surfaces));
  LUEUR_TRY(indirect, scene_errors(test.indirect, reference.indirect, &surfaces));
  report::Errors errors{reference_label, {}, {}};
  for (const report::Metric& metric : report::standard_metrics())
    errors.values.push_back({metric.name, value_of(composed, metric.name)});
  for (const std::string_view name : kIndirectMetrics)
    errors.values.push_back({"indirect_" + std::string(name), value_of(indirect, name)});
  errors.maps.push_back({"flip", std::move(composed.flip_map), 1.0});
  errors.maps.push_back({"indirect_rel_mse", std::move(indirect.relative_map), kFullRelativeError});
  return errors;
}

}  // namespace lueur::cli
