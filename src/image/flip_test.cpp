// SPDX-License-Identifier: MIT
#include "image/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>
#include <numeric>
#include <random>

namespace lueur {
namespace {

constexpr double kPi = std::numbers::pi;

ImageF noise(uint32_t width, uint32_t height, uint32_t seed) {
  ImageF image(width, height, 3);
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform;
  for (float& sample : image.samples) sample = uniform(random);
  return image;
}

ImageF uniform(const glm::dvec3& color) {
  ImageF image(24, 16, 3);
  for (size_t i = 0; i < image.samples.size(); ++i)
    image.samples[i] = static_cast<float>(color[static_cast<int>(i % 3)]);
  return image;
}

double mean_of(const ImageF& map) {
  return std::accumulate(map.samples.begin(), map.samples.end(), 0.0) /
         static_cast<double>(map.samples.size());
}

// --- The paper once more, in double precision, with its two-dimensional filters. -----------------

// From the chromaticities of Rec.709 and D65, instead of from a table.
glm::dmat3 xyz_from_rgb() {
  const auto xyz = [](double x, double y) { return glm::dvec3(x / y, 1.0, (1.0 - x - y) / y); };
  const glm::dmat3 primaries(xyz(0.64, 0.33), xyz(0.30, 0.60), xyz(0.15, 0.06));
  const glm::dvec3 luminances = glm::inverse(primaries) * xyz(0.3127, 0.3290);
  return glm::dmat3(primaries[0] * luminances[0], primaries[1] * luminances[1],
                    primaries[2] * luminances[2]);
}

glm::dvec3 relative_xyz(const glm::dvec3& rgb) {
  const glm::dmat3 m = xyz_from_rgb();
  return (m * rgb) / (m * glm::dvec3(1.0));
}

glm::dvec3 hunt_lab(const glm::dvec3& rgb) {
  glm::dvec3 f = relative_xyz(rgb);
  for (int c = 0; c < 3; ++c)
    f[c] = f[c] > std::pow(6.0 / 29.0, 3) ? std::cbrt(f[c]) : f[c] * 841.0 / 108.0 + 4.0 / 29.0;
  const double l = 116.0 * f.y - 16.0;
  return {l, 0.01 * l * 500.0 * (f.x - f.y), 0.01 * l * 200.0 * (f.y - f.z)};
}

double hyab(const glm::dvec3& a, const glm::dvec3& b) {
  return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

// From two filtered colours to the colour difference.
double color_difference(const glm::dvec3& a, const glm::dvec3& b) {
  const double largest = std::pow(hyab(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), 0.7);
  const double d = std::pow(hyab(hunt_lab(a), hunt_lab(b)), 0.7);
  const double knee = 0.4 * largest;
  return d < knee ? 0.95 * d / knee : 0.95 + 0.05 * (d - knee) / (largest - knee);
}

// Sums kernel(i, j) * value(x + i, y + j) over a square, borders repeated.
template <class Kernel, class Value>
auto sum_around(const ImageF& image, int x, int y, int radius, Kernel kernel, Value value) {
  decltype(kernel(0, 0) * value(0u, 0u)) sum{};
  for (int j = -radius; j <= radius; ++j)
    for (int i = -radius; i <= radius; ++i)
      sum += kernel(i, j) *
             value(static_cast<uint32_t>(std::clamp(x + i, 0, static_cast<int>(image.width) - 1)),
                   static_cast<uint32_t>(std::clamp(y + j, 0, static_cast<int>(image.height) - 1)));
  return sum;
}

struct Direct {
  const ImageF& image;
  double ppd;

  glm::dvec3 xyz(uint32_t x, uint32_t y) const {
    return relative_xyz({image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)});
  }

  // The colour that the eye resolves.
  glm::dvec3 seen(int x, int y) const {
    const int radius = static_cast<int>(std::ceil(3.0 * std::sqrt(0.04 / (2 * kPi * kPi)) * ppd));
    const auto gaussian = [&](int i, int j, double a, double b) {
      return a * kPi / b * std::exp(-kPi * kPi * (i * i + j * j) / (ppd * ppd) / b);
    };
    // HPG 2020: in two dimensions a sqrt(pi/b) exp(-pi^2 r^2 / b).
    const auto weights = [&](int i, int j) {
      const auto g = [&](double a, double b) { return gaussian(i, j, a, b) / std::sqrt(kPi / b); };
      return glm::dvec3(g(1.0, 0.0047), g(1.0, 0.0053), g(34.1, 0.04) + g(13.5, 0.025));
    };
    const glm::dvec3 total = sum_around(image, x, y, radius, weights,
                                        [](uint32_t, uint32_t) { return glm::dvec3(1.0); });
    const glm::dvec3 sum = sum_around(image, x, y, radius, weights, [&](uint32_t px, uint32_t py) {
      const glm::dvec3 v = xyz(px, py);
      return glm::dvec3(v.y, v.x - v.y, v.y - v.z);  // YCxCz but for factors and the offset
    });
    const glm::dvec3 f = sum / total;
    const glm::dvec3 filtered_xyz(f.x + f.y, f.x, f.x - f.z);
    const glm::dmat3 m = xyz_from_rgb();
    return glm::clamp(glm::inverse(m) * (filtered_xyz * (m * glm::dvec3(1.0))), 0.0, 1.0);
  }

  // Strength of the edge (order 1) or point (order 2).
  double feature(int x, int y, int order) const {
    const double sigma = 0.5 * 0.082 * ppd;
    const int radius = static_cast<int>(std::ceil(3.0 * sigma));
    const auto derivative = [&](int along, int across) {
      const double g = std::exp(-(along * along + across * across) / (2.0 * sigma * sigma));
      return order == 1 ? -along * g : (along * along / (sigma * sigma) - 1.0) * g;
    };
    double positive = 0.0, negative = 0.0;
    for (int j = -radius; j <= radius; ++j)
      for (int i = -radius; i <= radius; ++i)
        (derivative(i, j) > 0.0 ? positive : negative) += std::abs(derivative(i, j));
    const auto balanced = [&](int along, int across) {
      const double w = derivative(along, across);
      return w / (w > 0.0 ? positive : negative);
    };
    const auto grey = [&](uint32_t px, uint32_t py) { return xyz(px, py).y; };
    const double dx = sum_around(image, x, y, radius, balanced, grey);
    const double dy = sum_around(
        image, x, y, radius, [&](int i, int j) { return balanced(j, i); }, grey);
    return std::hypot(dx, dy);
  }
};

double direct_flip(const Direct& a, const Direct& b, int x, int y) {
  const double feature = std::max(std::abs(a.feature(x, y, 1) - b.feature(x, y, 1)),
                                  std::abs(a.feature(x, y, 2) - b.feature(x, y, 2)));
  return std::pow(color_difference(a.seen(x, y), b.seen(x, y)),
                  1.0 - std::sqrt(feature / std::sqrt(2.0)));
}

// Bound: the library's white point differs in the fifth digit from that of the chromaticities, and
// it computes in single precision.
TEST(Flip, IsItsDefinition) {
  const ImageF a = noise(13, 9, 1);
  ImageF b = noise(13, 9, 2);
  for (size_t i = 0; i < b.samples.size(); ++i)
    b.samples[i] = 0.4f * b.samples[i] + 0.6f * a.samples[i];
  for (const float ppd : {kFlipPixelsPerDegree, 20.0f}) {
    const ImageF map = flip_map(a, b, ppd);
    for (int y = 0; y < 9; y += 2)
      for (int x = 0; x < 13; x += 3)
        EXPECT_NEAR(map.at(static_cast<uint32_t>(x), static_cast<uint32_t>(y), 0),
                    direct_flip({a, ppd}, {b, ppd}, x, y), 5e-4)
            << x << ", " << y << " at " << ppd;
  }
}

TEST(Flip, EqualPicturesDoNotDiffer) {
  const ImageF image = noise(40, 30, 3);
  for (const float value : flip_map(image, image).samples) EXPECT_EQ(value, 0.0f);
}

// Without edges and points, FLIP is the difference of two colours.
TEST(Flip, UniformPicturesDifferInColour) {
  const std::pair<glm::dvec3, glm::dvec3> pairs[] = {{{0, 0, 0}, {1, 1, 1}},
                                                     {{0.2, 0.2, 0.2}, {0.3, 0.3, 0.3}},
                                                     {{0.5, 0.1, 0.1}, {0.1, 0.5, 0.1}},
                                                     {{0, 1, 0}, {0, 0, 1}}};
  for (const auto& [a, b] : pairs)
    for (const float value : flip_map(uniform(a), uniform(b)).samples)
      EXPECT_NEAR(value, color_difference(a, b), 2e-4);
}

TEST(Flip, BlackAgainstWhiteIsNearlyOne) {
  // Lightness differs by 100, of 203 between green and blue: in the range above the knee.
  EXPECT_NEAR(mean_of(flip_map(uniform(glm::dvec3(0)), uniform(glm::dvec3(1)))), 0.967, 1e-3);
}

TEST(Flip, IsSymmetric) {
  const ImageF a = noise(33, 21, 4), b = noise(33, 21, 5);
  EXPECT_EQ(flip_map(a, b).samples, flip_map(b, a).samples);
}

TEST(Flip, GrowsWithTheDifference) {
  double last = 0.0;
  for (const double step : {0.01, 0.03, 0.1, 0.3}) {
    const double error =
        mean_of(flip_map(uniform(glm::dvec3(0.2 + step)), uniform(glm::dvec3(0.2))));
    EXPECT_GT(error, last);
    last = error;
  }
}

TEST(Flip, FewerPixelsPerDegreeShowMore) {
  // Fine noise that is averaged out by the eye further away.
  const ImageF a = noise(48, 48, 6), b = noise(48, 48, 7);
  EXPECT_GT(mean_of(flip_map(a, b, 20.0f)), mean_of(flip_map(a, b, 80.0f)));
}

TEST(Flip, OnePixelDisturbsItsSurroundingsOnly) {
  const ImageF a = uniform(glm::dvec3(0.2));
  ImageF b = a;
  for (uint32_t c = 0; c < 3; ++c) b.at(3, 8, c) = 1.0f;
  const ImageF map = flip_map(a, b);
  EXPECT_GT(map.at(3, 8, 0), 0.1f);
  const size_t radius = flip_filters(kFlipPixelsPerDegree).y.size() / 2;
  for (uint32_t y = 0; y < map.height; ++y)
    for (uint32_t x = 3 + static_cast<uint32_t>(radius) + 1; x < map.width; ++x)
      EXPECT_EQ(map.at(x, y, 0), 0.0f) << x << ", " << y;
}

TEST(Flip, GreyAndCoverageChannels) {
  ImageF grey(24, 16, 1), covered(24, 16, 4);
  for (float& sample : grey.samples) sample = 0.5f;
  for (float& sample : covered.samples) sample = 0.5f;
  EXPECT_EQ(flip_map(grey, covered).samples, flip_map(covered, covered).samples);
}

TEST(Flip, FiltersAddUp) {
  for (const float ppd : {10.0f, 40.0f, kFlipPixelsPerDegree}) {
    const FlipFilters filters = flip_filters(ppd);
    const auto sum = [](const std::vector<float>& filter, float sign) {
      double result = 0.0;
      for (const float weight : filter) result += weight * sign > 0.0f ? double{weight} : 0.0;
      return result;
    };
    constexpr double kRounding = 1e-6;
    EXPECT_NEAR(sum(filters.y, 1.0f), 1.0, kRounding);
    EXPECT_NEAR(sum(filters.cx, 1.0f), 1.0, kRounding);
    EXPECT_NEAR(std::pow(sum(filters.cz1, 1.0f), 2) + std::pow(sum(filters.cz2, 1.0f), 2), 1.0,
                kRounding);
    EXPECT_NEAR(sum(filters.gaussian, 1.0f), 1.0, kRounding);
    EXPECT_NEAR(sum(filters.edge, 1.0f), 1.0, kRounding);
    EXPECT_NEAR(sum(filters.edge, -1.0f), -1.0, kRounding);
    EXPECT_NEAR(sum(filters.point, 1.0f), 1.0, kRounding);
    EXPECT_NEAR(sum(filters.point, -1.0f), -1.0, kRounding);
    for (const auto* filter : {&filters.y, &filters.cz2, &filters.point})
      for (size_t i = 0; i < filter->size(); ++i)
        EXPECT_EQ((*filter)[i], (*filter)[filter->size() - 1 - i]);
  }
  EXPECT_FLOAT_EQ(kFlipPixelsPerDegree, static_cast<float>(3840.0 * kPi / 180.0));
}

}  // namespace
}  // namespace lueur
