// SPDX-License-Identifier: MIT
#include "paper_fdp_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "frame/recorder.h"
#include "techniques/hierarchical/equations.h"

namespace lueur::cli::fdp {
namespace {

using Color = std::array<uint8_t, 3>;
constexpr Color kBackground{22, 22, 26}, kBorder{105, 105, 115}, kSample{240, 240, 240},
    kReceiver{235, 60, 50};
// By level, the finest first.
constexpr std::array<Color, 8> kLevelColors = {{{255, 250, 235},
                                                {250, 205, 90},
                                                {240, 140, 60},
                                                {200, 80, 95},
                                                {135, 60, 135},
                                                {90, 60, 150},
                                                {65, 65, 140},
                                                {50, 60, 110}}};

// Pixels of a level, by y and then x.
struct RowsFirst {
  bool operator()(glm::ivec2 a, glm::ivec2 b) const {
    return std::pair(a.y, a.x) < std::pair(b.y, b.x);
  }
};
using PixelSet = std::set<glm::ivec2, RowsFirst>;

int floor_divide(int a, int b) {
  return a >= 0 ? a / b : -((b - 1 - a) / b);
}

glm::ivec2 last_of(Extent e) {
  return glm::ivec2(static_cast<int>(e.width), static_cast<int>(e.height)) - 1;
}

// The coarse pixels between which upsample.glsl interpolates for these fine ones.
PixelSet corners_of(const PixelSet& fine, int factor, Extent coarse) {
  if (factor == 1) return fine;
  PixelSet corners;
  for (const glm::ivec2 p : fine)
    for (int i = 0; i < 4; ++i) {
      const glm::ivec2 corner{floor_divide(p.x - factor / 2, factor) + (i & 1),
                              floor_divide(p.y - factor / 2, factor) + (i >> 1)};
      corners.insert(glm::clamp(corner, glm::ivec2(0), last_of(coarse)));
    }
  return corners;
}

// What filter.comp averages for these.
PixelSet filtered(const PixelSet& pixels, Extent extent) {
  PixelSet all;
  for (const glm::ivec2 p : pixels)
    for (int i = 0; i < 9; ++i)
      all.insert(glm::clamp(p + glm::ivec2(i % 3, i / 3) - 1, glm::ivec2(0), last_of(extent)));
  return all;
}

Image8 canvas(Extent e) {
  Image8 image{e.width, e.height, 3, {}};
  for (size_t i = 0; i < size_t{e.width} * e.height; ++i)
    image.samples.insert(image.samples.end(), kBackground.begin(), kBackground.end());
  return image;
}

// A square, as far as it lies within the image.
void fill(Image8& image, glm::ivec2 from, int side, const Color& color) {
  for (int y = std::max(from.y, 0); y < std::min(from.y + side, static_cast<int>(image.height));
       ++y)
    for (int x = std::max(from.x, 0); x < std::min(from.x + side, static_cast<int>(image.width));
         ++x)
      std::copy(
          color.begin(), color.end(),
          &image.samples[3 * (static_cast<size_t>(y) * image.width + static_cast<size_t>(x))]);
}

void draw_circle(Image8& image, float centre, float radius) {
  const int steps = static_cast<int>(8.0f * radius);
  for (int i = 0; i < steps; ++i) {
    const float angle = kTurn * static_cast<float>(i) / static_cast<float>(steps);
    fill(image, glm::ivec2(centre + radius * glm::vec2(std::cos(angle), std::sin(angle))), 1,
         kBorder);
  }
}

}  // namespace

std::vector<glm::ivec2> sample_pixels(const HierarchicalSettings& settings, uint32_t level,
                                      glm::ivec2 pixel, uint32_t seed) {
  const uint32_t samples = samples_at_level(settings, level);
  const float inner_px = ring_inner_px(level, settings.radius);
  const glm::vec2 start = spiral_start(glm::uvec2(pixel), level, seed, settings.rotate);
  const float step_px2 = sample_step_px2(inner_px, settings.radius, samples);
  std::vector<glm::ivec2> places;
  for (uint32_t i = 0; i < samples; ++i) {
    const float radius_px = sample_radius_px(inner_px, step_px2, static_cast<float>(i) + start.x);
    const float angle = kTurn * start.y + kGoldenAngle * static_cast<float>(i);
    places.emplace_back(glm::floor(glm::vec2(pixel) + 0.5f +
                                   radius_px * glm::vec2(std::cos(angle), std::sin(angle))));
  }
  return places;
}

std::vector<uint8_t> participating_pixels(const HierarchicalSettings& settings, Extent extent,
                                          glm::ivec2 receiver, uint32_t seed) {
  std::vector<uint8_t> taken(size_t{extent.width} * extent.height);
  // A pixel of the level covers so many of the image's a side.
  uint32_t side = 1u << static_cast<uint32_t>(settings.start);
  PixelSet pixels = {receiver};
  int factor = static_cast<int>(side);
  for (uint32_t level = 0; level < static_cast<uint32_t>(settings.levels); ++level, side *= 2) {
    const Extent level_extent{divide_up(extent.width, side), divide_up(extent.height, side)};
    pixels = corners_of(pixels, factor, level_extent);
    if (settings.filter) pixels = filtered(pixels, level_extent);
    factor = 2;
    if (settings.only_level != 0 && settings.only_level != static_cast<int>(level) + 1) continue;
    for (const glm::ivec2 pixel : pixels)
      for (const glm::ivec2 q : sample_pixels(settings, level, pixel, seed)) {
        if (q.x < 0 || q.y < 0 || q.x > last_of(level_extent).x || q.y > last_of(level_extent).y)
          continue;
        for (uint32_t y = static_cast<uint32_t>(q.y) * side;
             y < std::min((static_cast<uint32_t>(q.y) + 1) * side, extent.height); ++y)
          for (uint32_t x = static_cast<uint32_t>(q.x) * side;
               x < std::min((static_cast<uint32_t>(q.x) + 1) * side, extent.width); ++x) {
            uint8_t& at = taken[size_t{y} * extent.width + x];
            if (at == 0) at = static_cast<uint8_t>(level + 1);
          }
      }
  }
  return taken;
}

Image8 draw_samples(const HierarchicalSettings& settings, uint32_t level, uint32_t seed) {
  constexpr int kScale = 5, kMargin = 2;
  const int reach = static_cast<int>(std::ceil(settings.radius)) + kMargin;
  const auto side = static_cast<uint32_t>(kScale * (2 * reach + 1));
  Image8 image = canvas({side, side});
  const glm::ivec2 centre(reach);
  for (const float radius : {ring_inner_px(level, settings.radius), settings.radius})
    draw_circle(image, 0.5f * static_cast<float>(side), kScale * radius);
  for (const glm::ivec2 q : sample_pixels(settings, level, centre, seed))
    fill(image, kScale * q, kScale, kSample);
  fill(image, kScale * centre, kScale, kReceiver);
  return image;
}

Image8 draw_participants(const HierarchicalSettings& settings, Extent extent, uint32_t seed) {
  Image8 image = canvas(extent);
  const glm::ivec2 receiver = (last_of(extent) + 1) / 2;
  const std::vector<uint8_t> taken = participating_pixels(settings, extent, receiver, seed);
  for (size_t i = 0; i < taken.size(); ++i)
    if (taken[i] > 0) std::copy_n(kLevelColors[taken[i] - 1u].begin(), 3, &image.samples[3 * i]);
  fill(image, receiver - 4, 9, kReceiver);
  return image;
}

}  // namespace lueur::cli::fdp
