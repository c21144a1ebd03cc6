// SPDX-License-Identifier: MIT
// Writes pages for page_test.mjs, and to look at: sample_pages FOLDER [WIDTH HEIGHT].
//   FOLDER/full      techniques, references, maps and labels that try to be markup
//   FOLDER/one       one technique, no reference
//   FOLDER/empty     nothing at all
//   FOLDER/figures   each kind of block
//   FOLDER/sheet     more scenes than fit a window, and files that were refused
//   FOLDER/expected.json   what pixels of `full` must look like
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

#include "base/file.h"
#include "base/try.h"
#include "image/png.h"
#include "report/comparison.h"
#include "report/figure_page.h"
#include "report/folder.h"
#include "report/sheet.h"

namespace lueur::report {
namespace {

namespace fs = std::filesystem;

// A sunlit ball on a floor, coloured light around it: values from 0.002 to about 30. `strength`
// scales the indirect part, `noise` is the relative deviation of a pixel.
struct Look {
  float strength = 1.0f;
  float noise = 0.0f;
  uint32_t seed = 1;
};

Pictures render(uint32_t width, uint32_t height, const Look& look) {
  Pictures pictures{ImageF(width, height, 3), ImageF(width, height, 3)};
  std::mt19937 random(look.seed);
  std::normal_distribution<float> deviation(1.0f, look.noise);
  for (uint32_t y = 0; y < height; ++y) {
    for (uint32_t x = 0; x < width; ++x) {
      const float u = 2.0f * (static_cast<float>(x) + 0.5f) / static_cast<float>(height) -
                      static_cast<float>(width) / static_cast<float>(height);
      const float v = 1.0f - 2.0f * (static_cast<float>(y) + 0.5f) / static_cast<float>(height);
      const float r2 = (u * u + v * v) / 0.36f;
      const float nz = r2 < 1.0f ? std::sqrt(1.0f - r2) : 0.0f;
      const float sun = r2 < 1.0f ? std::max(0.0f, 0.6f * u / 0.6f + 0.6f * v / 0.6f + 0.5f * nz)
                                  : (v < -0.5f && u < 0.2f ? 1.2f : 0.0f);
      const float glint = r2 < 1.0f ? std::pow(std::max(0.0f, sun / 1.4f), 60.0f) * 30.0f : 0.0f;
      const float grain = look.noise > 0.0f ? std::max(0.0f, deviation(random)) : 1.0f;
      const float around[3] = {0.25f + 0.2f * u, 0.22f + 0.05f * v, 0.25f - 0.13f * u};
      const float albedo[3] = {0.8f, 0.7f, r2 < 1.0f ? 0.15f : 0.6f};
      for (uint32_t c = 0; c < 3; ++c) {
        const float indirect =
            std::max(0.002f, around[c]) * look.strength * grain * (r2 < 1.0f ? 1.3f - nz : 1.0f);
        pictures.indirect.at(x, y, c) = indirect;
        pictures.composed.at(x, y, c) = albedo[c] * (sun + indirect) + glint;
      }
    }
  }
  return pictures;
}

ImageF error_map(const ImageF& image, const ImageF& truth) {
  ImageF map(image.width, image.height, 1);
  for (size_t i = 0; i < map.samples.size(); ++i)
    for (size_t c = 3 * i; c < 3 * i + 3; ++c)
      map.samples[i] += std::min(1.0f, std::abs(image.samples[c] - truth.samples[c]) * 2.0f) / 3.0f;
  return map;
}

Errors errors_of(const Pictures& pictures, const Reference& reference) {
  double squares = 0.0;
  double sum = 0.0;
  const std::vector<float>& truth = reference.pictures.composed.samples;
  for (size_t i = 0; i < truth.size(); ++i) {
    const double difference = double{pictures.composed.samples[i]} - double{truth[i]};
    squares += difference * difference;
    sum += difference;
  }
  const double mse = squares / static_cast<double>(truth.size());
  Errors errors;
  errors.reference = reference.label;
  errors.values = {{"rmse", std::sqrt(mse)},
                   {"psnr", -10.0 * std::log10(mse)},
                   {"bias", sum / static_cast<double>(truth.size())}};
  errors.maps.push_back({"flip", error_map(pictures.composed, reference.pictures.composed), 1.0});
  return errors;
}

Entry entry_of(const Comparison& comparison, const std::string& label, double ms,
               const Look& look) {
  Entry entry;
  entry.label = label;
  entry.technique = ms > 0.0 ? "hierarchical" : "none";
  entry.technique_ms = ms;
  entry.frame_ms = 20.0 + ms;
  entry.passes = {{"renderer.g_buffer", 8.0}, {"renderer.light", 12.0}};
  if (ms > 0.0) {
    entry.settings = {{"start", "half"}, {"samples", std::lround(ms * 2.0)}, {"rotate", true}};
    for (int level = 0; level < 5; ++level)
      entry.passes.push_back({"hierarchical.gather@" + std::to_string(level), ms / (2 << level)});
  }
  entry.pictures = render(comparison.width, comparison.height, look);
  for (const Reference& reference : comparison.references)
    entry.errors.push_back(errors_of(entry.pictures, reference));
  return entry;
}

Comparison full(uint32_t width, uint32_t height) {
  Comparison comparison;
  comparison.title = "ball: three techniques & <two> references";
  comparison.scene = "ball";
  comparison.camera = "front";
  comparison.width = width;
  comparison.height = height;
  comparison.device = "none, computed";
  comparison.exposure_ev = 0.5;
  comparison.command = "lueur compare ball --techniques none,hierarchical --reference path,screen";
  comparison.warnings = {"a warning </script><script>alert(1)</script>"};
  comparison.references = {
      {"path", "path", 256, 0.01, 84.2, render(width, height, {1.0f, 0.04f, 3})},
      {"screen", "screen", 64, std::nullopt, 20.5, render(width, height, {0.8f, 0.02f, 4})}};
  comparison.entries = {
      entry_of(comparison, "none", 0.0, {0.0f}),
      entry_of(comparison, "hierarchical, 16 <b>samples</b>", 8.0, {0.7f, 0.02f, 1}),
      entry_of(comparison, "hierarchical \"fine\" </script>", 64.0, {0.95f, 0.01f, 2})};
  comparison.direct = comparison.entries[0].pictures.composed;
  return comparison;
}

Comparison one(uint32_t width, uint32_t height) {
  Comparison comparison;
  comparison.title = "one technique";
  comparison.width = width;
  comparison.height = height;
  comparison.entries = {entry_of(comparison, "hierarchical", 8.0, {})};
  return comparison;
}

// Code values and linear values of pixels spread over the second entry's composed picture.
Json expected_pixels(const Comparison& comparison) {
  Json pixels = Json::array();
  const ImageF& image = comparison.entries[1].pictures.composed;
  for (const ToneMapName& tone_map : kToneMapNames) {
    for (const double stops : {-3.0, 0.0, 2.5}) {
      const Image8 display =
          to_display(image, static_cast<float>(comparison.exposure_ev + stops), tone_map.tone_map);
      for (uint32_t i = 0; i < 40; ++i) {
        const uint32_t x = i * 37 % image.width;
        const uint32_t y = i * 23 % image.height;
        const uint8_t* code = &display.samples[(size_t{y} * image.width + x) * 3];
        pixels.push_back({{"tone_map", tone_map.name},
                          {"stops", stops},
                          {"x", x},
                          {"y", y},
                          {"display", {code[0], code[1], code[2]}},
                          {"linear", {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)}}});
      }
    }
  }
  return pixels;
}

FigurePage figures(const Comparison& comparison) {
  const ImageF& image = comparison.entries[1].pictures.composed;
  const uint32_t row = image.height / 2;
  Plot slice{"Intensity along the line.", {"x in px"}, {"radiance", true}, {}};
  for (const Entry& entry : comparison.entries) {
    Curve curve{entry.label, {}, entry.technique == "none"};
    for (uint32_t x = 0; x < image.width; ++x)
      curve.points.emplace_back(x, entry.pictures.composed.at(x, row, 1));
    slice.curves.push_back(std::move(curve));
  }
  const double y = row + 0.5;
  const Image8 display = to_display(image, 0.0f, ToneMap::khronos_neutral);
  FigurePage page;
  page.title = "Figures of <a paper>";
  page.summary = "What a paper shows beside what is rendered here.";
  page.facts = {{"device", comparison.device}};
  page.command = "lueur paper";
  page.sections = {{"Figure 1: the ball",
                    {Paragraph{"A line shows where the slice was taken."},
                     PictureRow{{{display, "left & right", {{0.0, y, double(image.width), y}}},
                                 {display, "the same", {}}},
                                "Both at one exposure."},
                     slice}},
                   {"Figure 2: cost",
                    {Table{"Times of a frame",
                           {{"level", "", ""}, {"time", "ms", "paper"}, {"time", "ms", "ours"}},
                           {{"full", 12.5, 187.0}, {"half", std::monostate{}, 61.25}}}}}};
  return page;
}

// Scenes with one to three cameras, each picture brighter than the one before.
Result<Sheet> sheet(uint32_t width, uint32_t height) {
  Sheet sheet;
  sheet.title = "Sheet of <scenes>";
  sheet.facts = {{"device", "none, computed"}};
  sheet.command = "lueur scene sheet models";
  sheet.width = width;
  sheet.height = height;
  for (uint64_t i = 0; i < 60; ++i) {
    const std::string name = "scene " + std::to_string(i);
    SheetScene scene{name, "models/a long path/" + name + "/file.glb", i * 1000 + 1, 0.3, {}, {}};
    if (i % 5 == 0) scene.warnings = {"no light: a sun was added", "</script><b>bold</b>"};
    for (uint64_t camera = 0; camera <= i % 3; ++camera) {
      const float strength = 0.2f + 0.02f * static_cast<float>(i + camera);
      LUEUR_TRY(png, encode_png(to_display(render(width, height, {strength}).composed, 0.0f,
                                           ToneMap::khronos_neutral),
                                name));
      scene.pictures.push_back({"camera " + std::to_string(camera), -1.5f, std::move(png)});
    }
    sheet.scenes.push_back(std::move(scene));
  }
  sheet.refused = {{"models/bad.glb", "shorter than its header says"},
                   {"models/<b>worse</b>.gltf", "not JSON"}};
  return sheet;
}

Result<void> write_pages(const fs::path& folder, uint32_t width, uint32_t height) {
  const Comparison comparison = full(width, height);
  LUEUR_TRY_VOID(write_comparison(comparison, folder / "full"));
  LUEUR_TRY_VOID(write_comparison(one(width, height), folder / "one"));
  LUEUR_TRY_VOID(write_comparison({.title = "nothing"}, folder / "empty"));
  LUEUR_TRY_VOID(write_figure_page(figures(comparison), folder / "figures"));
  LUEUR_TRY(scenes, sheet(width, height));
  LUEUR_TRY_VOID(make_folder(folder / "sheet"));
  LUEUR_TRY_VOID(write_sheet(scenes, folder / "sheet" / "index.html"));
  return write_file(folder / "expected.json", expected_pixels(comparison).dump());
}

}  // namespace
}  // namespace lueur::report

int main(int argc, char** argv) {
  if (argc != 2 && argc != 4) {
    std::fputs("usage: sample_pages FOLDER [WIDTH HEIGHT]\n", stderr);
    return 2;
  }
  const uint32_t width = argc == 4 ? static_cast<uint32_t>(std::atoi(argv[2])) : 192;
  const uint32_t height = argc == 4 ? static_cast<uint32_t>(std::atoi(argv[3])) : 108;
  const auto written = lueur::report::write_pages(argv[1], width, height);
  if (!written.ok()) std::fprintf(stderr, "%s\n", written.error().message.c_str());
  return written.ok() ? 0 : 1;
}
