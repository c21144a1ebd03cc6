// SPDX-License-Identifier: MIT
#include "reference/environment_light.h"

#include <algorithm>
#include <cmath>

#include "image/exposure.h"
#include "shading/environment.h"

namespace lueur::reference {
namespace {

constexpr double kPiExact = 3.14159265358979323846;

// Cosine of the angle from +y at the upper edge of a row.
double cosine_at(size_t row, uint32_t height) {
  return std::cos(kPiExact * static_cast<double>(row) / height);
}

// The first entry above `choice`: entries without a share of their own are never chosen.
size_t chosen(const float* begin, size_t count, float choice) {
  const float* found = std::upper_bound(begin, begin + count, choice);
  return std::min(static_cast<size_t>(found - begin), count - 1);
}

}  // namespace

EnvironmentLight::EnvironmentLight(const Environment& environment)
    : environment_(&environment), environment_from_world_(environment_from_world(environment)) {
  const uint32_t width = environment.width, height = environment.height;
  pixels_.resize(size_t{width} * height);
  std::vector<double> row_sums;
  for (size_t row = 0; row < height; ++row) {
    double sum = 0.0;
    std::vector<double> cumulative(width);
    for (size_t column = 0; column < width; ++column) {
      const glm::vec3 light = radiance_at(row * width + column);
      sum += static_cast<double>(luminance(light.r, light.g, light.b));
      cumulative[column] = sum;
    }
    for (size_t column = 0; column < width; ++column)
      pixels_[row * width + column] =
          sum > 0.0 ? static_cast<float>(cumulative[column] / sum) : 0.0f;
    const double solid_angle =
        2.0 * kPiExact / width * (cosine_at(row, height) - cosine_at(row + 1, height));
    total_ += sum * solid_angle;
    row_sums.push_back(total_);
  }
  for (const double sum : row_sums)
    rows_.push_back(total_ > 0.0 ? static_cast<float>(sum / total_) : 0.0f);
}

glm::vec3 EnvironmentLight::radiance_at(size_t pixel) const {
  const float* rgb = environment_->rgb.data() + pixel * 3;
  return environment_->intensity * glm::vec3(rgb[0], rgb[1], rgb[2]);
}

// Luminance times solid angle over the total, over the solid angle.
float EnvironmentLight::pdf_at(size_t pixel) const {
  const glm::vec3 light = radiance_at(pixel);
  return static_cast<float>(static_cast<double>(luminance(light.r, light.g, light.b)) / total_);
}

size_t EnvironmentLight::pixel_of(const glm::vec3& direction) const {
  const vec2 uv = environment_uv(environment_from_world_ * direction);
  const auto place = [](float share, uint32_t count) {
    const float at = share * static_cast<float>(count);
    return static_cast<size_t>(std::clamp(at, 0.0f, static_cast<float>(count - 1)));
  };
  return place(uv.y, environment_->height) * environment_->width + place(uv.x, environment_->width);
}

EnvironmentLight::Sample EnvironmentLight::sample(const glm::vec2& choice,
                                                  const glm::vec2& u) const {
  const uint32_t width = environment_->width, height = environment_->height;
  const size_t row = chosen(rows_.data(), height, choice.y);
  const size_t column = chosen(pixels_.data() + row * width, width, choice.x);
  const size_t pixel = row * width + column;

  // Even over the pixel's solid angle: even in the angle around and in the height.
  const double around =
      2.0 * kPiExact * ((static_cast<double>(column) + double{u.x}) / width - 0.5);
  const double top = cosine_at(row, height), bottom = cosine_at(row + 1, height);
  const double y = top + (bottom - top) * double{u.y};
  const double across = std::sqrt(std::max(1.0 - y * y, 0.0));
  const glm::vec3 own(across * std::sin(around), y, -across * std::cos(around));
  return {glm::normalize(glm::transpose(environment_from_world_) * own), radiance_at(pixel),
          pdf_at(pixel)};
}

glm::vec3 EnvironmentLight::radiance(const glm::vec3& direction) const {
  return radiance_at(pixel_of(direction));
}

float EnvironmentLight::pdf(const glm::vec3& direction) const {
  return pdf_at(pixel_of(direction));
}

Backdrop::Backdrop(const Environment& environment, const Camera& camera, uint32_t height_px)
    : level_(environment_level(
          environment,
          background_level(environment, 2.0f * std::tan(0.5f * camera.vertical_fov_rad) /
                                            static_cast<float>(std::max(height_px, 1u))))),
      environment_from_world_(environment_from_world(environment)),
      intensity_(environment.intensity) {}

// Goes on around in x, and stops at the poles in y.
glm::vec3 Backdrop::pixel(int64_t x, int64_t y) const {
  const int64_t width = level_.width, height = level_.height;
  const int64_t column = (x % width + width) % width, row = std::clamp<int64_t>(y, 0, height - 1);
  const float* rgb = level_.rgb.data() + (row * width + column) * 3;
  return {rgb[0], rgb[1], rgb[2]};
}

glm::vec3 Backdrop::at(const glm::vec3& direction) const {
  const vec2 uv = environment_uv(environment_from_world_ * direction);
  const float x = uv.x * static_cast<float>(level_.width) - 0.5f;
  const float y = uv.y * static_cast<float>(level_.height) - 0.5f;
  const float left = std::floor(x), top = std::floor(y);
  const auto column = static_cast<int64_t>(left), row = static_cast<int64_t>(top);
  const glm::vec3 above = glm::mix(pixel(column, row), pixel(column + 1, row), x - left);
  const glm::vec3 below = glm::mix(pixel(column, row + 1), pixel(column + 1, row + 1), x - left);
  return intensity_ * glm::mix(above, below, y - top);
}

}  // namespace lueur::reference
