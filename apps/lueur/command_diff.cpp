// SPDX-License-Identifier: MIT
// lueur diff: how far a picture is from its reference.
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <memory>
#include <span>

#include "arguments.h"
#include "base/try.h"
#include "commands.h"
#include "console.h"
#include "destination.h"
#include "image/color_map.h"
#include "image/exr.h"
#include "image/picture_error.h"
#include "image/png.h"
#include "json_output.h"

namespace lueur::cli {
namespace {

// What was typed, before it is checked.
struct DiffOptions {
  std::string test;
  std::string reference;
  std::string layer;
  std::string mask_layer;
  std::vector<std::string> metrics;
  std::string fail_above;
  std::string output;
  std::string map;
  bool json = false;
};

// A picture of one value in [0, 1] for each pixel.
struct ErrorMap {
  const char* name;
  ImageF (*make)(const PictureErrors& errors);
};

ImageF dissimilarity(const PictureErrors& errors) {
  ImageF map = errors.ssim_map;
  for (float& value : map.samples) value = 1.0f - value;
  return map;
}

constexpr ErrorMap kMaps[] = {
    {"flip", [](const PictureErrors& errors) { return errors.flip_map; }},
    {"relative", [](const PictureErrors& errors) { return errors.relative_map; }},
    {"ssim", dissimilarity}};

struct DiffPlan {
  FileKind kind = FileKind::png;
  std::vector<const ErrorMetric*> shown;
  const ErrorMetric* limited = nullptr;  // the metric of --fail-above; nullptr without
  double limit = 0.0;
  const ErrorMap* map = kMaps;
};

Result<FileKind> kind_of(const std::string& path) {
  const std::string ending = ending_of(path);
  if (ending == ".png") return FileKind::png;
  if (ending == ".exr") return FileKind::exr;
  return Error{ErrorKind::usage, "'" + path + "': the name of a picture ends in .png or .exr"};
}

Result<void> check_limit(const DiffOptions& options, DiffPlan& job) {
  if (options.fail_above.empty()) return {};
  if (options.metrics.size() > 1)
    return Error{ErrorKind::usage, "--fail-above holds for one metric; give --metric once"};
  LUEUR_TRY(limit, parse_real("--fail-above", options.fail_above, 1e9f));
  if (limit < 0.0f)
    return Error{ErrorKind::usage, "--fail-above '" + options.fail_above + "': expected 0 or more"};
  LUEUR_TRY(metric,
            find_named("--metric", options.metrics.empty() ? "flip" : options.metrics.front(),
                       kErrorMetrics));
  if (!metric->is_error)
    return Error{ErrorKind::usage, "--fail-above: " + std::string(metric->name) +
                                       " does not grow with the error; choose another --metric"};
  job.limit = static_cast<double>(limit);
  job.limited = metric;
  return {};
}

Result<DiffPlan> check(const DiffOptions& options) {
  DiffPlan job;
  LUEUR_TRY(kind, kind_of(options.test));
  LUEUR_TRY(reference_kind, kind_of(options.reference));
  if (kind != reference_kind)
    return Error{ErrorKind::usage,
                 "'" + options.test + "' and '" + options.reference +
                     "': a PNG holds what a display shows, an EXR light; compare two of a kind"};
  job.kind = kind;
  for (const auto& [flag, layer] :
       {std::pair("--layer", &options.layer), {"--mask-layer", &options.mask_layer}})
    if (!layer->empty() && job.kind == FileKind::png)
      return Error{ErrorKind::usage, std::string(flag) + " '" + *layer +
                                         "': PNG files have no layers; give EXR files"};
  for (const std::string& name : options.metrics) {
    LUEUR_TRY(metric, find_named("--metric", name, kErrorMetrics));
    job.shown.push_back(metric);
  }
  if (job.shown.empty())
    for (const ErrorMetric& metric : kErrorMetrics) job.shown.push_back(&metric);
  LUEUR_TRY_VOID(check_limit(options, job));
  if (!options.map.empty()) {
    LUEUR_TRY(map, find_named("--map", options.map, kMaps));
    job.map = map;
  }
  if (!options.output.empty()) {
    if (ending_of(options.output) != ".png")
      return Error{ErrorKind::usage, "-o '" + options.output + "': the name has to end in .png"};
    LUEUR_TRY_VOID(check_writable(options.output));
  }
  return job;
}

const ImageF* find_layer(std::span<const ImageLayer> layers, const std::string& name) {
  for (const ImageLayer& layer : layers)
    if (layer.name == name) return &layer.image;
  return nullptr;
}

Result<const ImageF*> choose_layer(const std::string& path, std::span<const ImageLayer> layers,
                                   const std::string& name) {
  const ImageF* image = find_layer(layers, name);
  const std::string what = name.empty() ? "main picture" : "layer '" + name + "'";
  if (image != nullptr) {
    LUEUR_TRY_VOID(check_finite(*image, path + ", " + what));
    return image;
  }
  std::vector<std::string> names;
  for (const ImageLayer& layer : layers)
    names.push_back(layer.name.empty() ? "(main)" : layer.name);
  return Error{ErrorKind::input, path + ": has no " + what + "; its layers are " + joined(names)};
}

// Puts the files before an error that only speaks of test and reference.
Result<PictureErrors> named(const DiffOptions& options, Result<PictureErrors> errors) {
  if (errors.ok()) return errors;
  return Error{errors.error().kind,
               options.test + " against " + options.reference + ": " + errors.error().message};
}

Result<PictureErrors> compare_exr(const DiffOptions& options) {
  LUEUR_TRY(test_layers, read_exr(options.test));
  LUEUR_TRY(reference_layers, read_exr(options.reference));
  LUEUR_TRY(test, choose_layer(options.test, test_layers, options.layer));
  LUEUR_TRY(reference, choose_layer(options.reference, reference_layers, options.layer));
  if (options.mask_layer.empty()) return named(options, scene_errors(*test, *reference));
  // A reference of another program may have no such layer; both show the same view.
  const bool in_reference = find_layer(reference_layers, options.mask_layer) != nullptr;
  LUEUR_TRY(mask_layer, in_reference
                            ? choose_layer(options.reference, reference_layers, options.mask_layer)
                            : choose_layer(options.test, test_layers, options.mask_layer));
  const Mask mask = mask_of(*mask_layer);
  return named(options, scene_errors(*test, *reference, &mask));
}

Result<PictureErrors> compare_png(const DiffOptions& options) {
  LUEUR_TRY(test, read_png(options.test));
  LUEUR_TRY(reference, read_png(options.reference));
  return named(options, display_errors(test, reference));
}

Json as_json(const DiffOptions& options, const DiffPlan& job, const PictureErrors& errors) {
  Json json = {{"a", options.test},
               {"b", options.reference},
               {"layer", options.layer},
               {"size", size_json({errors.flip_map.width, errors.flip_map.height})}};
  for (const ErrorMetric* metric : job.shown)
    json[std::string(metric->name)] = errors.*metric->value;
  return json;
}

std::string as_text(const DiffOptions& options, const DiffPlan& job, const PictureErrors& errors) {
  std::string text = printable(options.test) + " against " + printable(options.reference);
  if (!options.layer.empty()) text += ", layer " + printable(options.layer);
  text += ", " + std::to_string(errors.flip_map.width) + "x" +
          std::to_string(errors.flip_map.height) + "\n";
  for (const ErrorMetric* metric : job.shown) {
    char line[128];
    std::snprintf(line, sizeof(line), "  %-12s %12.6g  %s\n", metric->name.data(),
                  errors.*metric->value, metric->summary.data());
    text += line;
  }
  return text;
}

Outcome run(const DiffOptions& options) {
  LUEUR_TRY(job, check(options));
  LUEUR_TRY(errors, job.kind == FileKind::png ? compare_png(options) : compare_exr(options));
  if (!options.output.empty())
    LUEUR_TRY_VOID(write_png(options.output, in_magma(job.map->make(errors))));
  LUEUR_TRY_VOID(options.json ? print_json(as_json(options, job, errors))
                              : print_data(as_text(options, job, errors)));
  if (job.limited == nullptr) return kExitDone;
  const double value = errors.*job.limited->value;
  if (std::abs(value) <= job.limit) return kExitDone;
  print_error("diff: " + std::string(job.limited->name) + " is " + std::to_string(value) +
              ", beyond the limit of " + options.fail_above);
  return kExitFinding;
}

constexpr char kDiffFooter[] =
    "Two PNG files are compared as a display shows them; two EXR files as light, by their main\n"
    "pictures or by the layer that --layer names. psnr, ssim and the exposures of flip are then\n"
    "metered on B. In JSON a number that is infinite, such as psnr of equal pictures, is null.\n"
    "\n"
    "Examples:\n"
    "  lueur diff fast.png exact.png\n"
    "  lueur diff fast.exr exact.exr --layer indirect --mask-layer depth --json\n"
    "  lueur diff fast.exr exact.exr --metric rel_mse --fail-above 0.1\n"
    "  lueur diff fast.png exact.png -o where.png --map flip\n";

}  // namespace

void add_diff(CLI::App& program, Outcome& outcome) {
  CLI::App* command = program.add_subcommand("diff", "Measure a picture against its reference");
  auto options = std::make_shared<DiffOptions>();
  command->add_option("A", options->test, "The picture to measure, .png or .exr")
      ->type_name("")
      ->required();
  command->add_option("B", options->reference, "The reference, of the same kind and size")
      ->type_name("")
      ->required();
  command->add_option("--layer", options->layer, "A layer of the EXR files, such as indirect")
      ->type_name("NAME");
  command
      ->add_option("--mask-layer", options->mask_layer,
                   "Only pixels where this layer of B, or of A where B has none, is not 0")
      ->type_name("NAME");
  std::vector<std::string> metrics;
  for (const ErrorMetric& metric : kErrorMetrics) metrics.emplace_back(metric.name);
  command
      ->add_option("--metric", options->metrics,
                   "Show only this one of " + joined(metrics) + "; may be repeated")
      ->type_name("NAME")
      ->allow_extra_args(false);
  command
      ->add_option("--fail-above", options->fail_above,
                   "Exit with 1 if the one --metric (default flip) is beyond +-X")
      ->type_name("X");
  auto* output = command->add_option("-o,--output", options->output, "A map of the error, .png")
                     ->type_name("FILE");
  command
      ->add_option("--map", options->map,
                   "What -o shows: flip, relative (the root of a pixel's rel_mse) or ssim (1 - "
                   "ssim), from black at 0 to pale yellow at 1 and more (default flip)")
      ->type_name("NAME")
      ->needs(output);
  command->add_flag("--json", options->json, "One JSON object on stdout");
  command->footer(std::string(kDiffFooter) + kExitCodes);
  command->callback([options, &outcome] { outcome = run(*options); });
}

}  // namespace lueur::cli
