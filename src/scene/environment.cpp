// SPDX-License-Identifier: MIT
#include "scene/environment.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace lueur {
namespace {

// What of the row [0, from) a pixel of [0, to) covers, in pixels of the former.
struct Span {
  uint32_t first = 0, last = 0;  // inclusive
  double begin = 0.0, end = 0.0;
  double share(uint32_t i) const {
    return std::max(std::min(end, i + 1.0) - std::max(begin, static_cast<double>(i)), 0.0) /
           (end - begin);
  }
};
Span span_of(uint32_t pixel, uint32_t from, uint32_t to) {
  const double begin = static_cast<double>(pixel) * from / to, end = (pixel + 1.0) * from / to;
  const auto last = static_cast<uint32_t>(std::ceil(end)) - 1;
  return {static_cast<uint32_t>(begin), std::min(last, from - 1), begin, end};
}

}  // namespace

glm::mat3 environment_from_world(const Environment& environment) {
  const float c = std::cos(environment.rotation_rad), s = std::sin(environment.rotation_rad);
  // The transpose of the rotation by +rotation_rad about y; columns.
  return {{c, 0.0f, s}, {0.0f, 1.0f, 0.0f}, {-s, 0.0f, c}};
}

EnvironmentLevel environment_level(const Environment& environment, uint32_t level) {
  EnvironmentLevel result{environment.width, environment.height, environment.rgb};
  for (uint32_t i = 0; i < level; ++i) result = halved(result);
  return result;
}

EnvironmentLevel halved(const EnvironmentLevel& from) {
  EnvironmentLevel to{std::max(from.width / 2, 1u), std::max(from.height / 2, 1u), {}};
  to.rgb.reserve(size_t{to.width} * to.height * 3);
  for (uint32_t y = 0; y < to.height; ++y) {
    const Span rows = span_of(y, from.height, to.height);
    for (uint32_t x = 0; x < to.width; ++x) {
      const Span columns = span_of(x, from.width, to.width);
      glm::dvec3 sum(0.0);
      for (uint32_t row = rows.first; row <= rows.last; ++row)
        for (uint32_t column = columns.first; column <= columns.last; ++column) {
          const float* rgb = from.rgb.data() + (size_t{row} * from.width + column) * 3;
          sum += rows.share(row) * columns.share(column) *
                 glm::dvec3(double{rgb[0]}, double{rgb[1]}, double{rgb[2]});
        }
      for (int c = 0; c < 3; ++c) to.rgb.push_back(static_cast<float>(sum[c]));
    }
  }
  return to;
}

uint32_t environment_level_count(const Environment& environment) {
  return static_cast<uint32_t>(std::bit_width(std::max(environment.width, environment.height)));
}

uint32_t background_level(const Environment& environment, float pixel_rad) {
  const float own_pixel_rad = glm::pi<float>() / static_cast<float>(environment.height);
  const float level = std::floor(std::log2(pixel_rad / own_pixel_rad));
  const float last = static_cast<float>(environment_level_count(environment) - 1);
  return static_cast<uint32_t>(std::clamp(level, 0.0f, last));
}

}  // namespace lueur
