// SPDX-License-Identifier: MIT
#include "image/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "base/check.h"
#include "image/separable_filter.h"

namespace lueur {
namespace {

using Color = std::array<float, 3>;

// Exponents, knee and width of the paper's section 4, by its names.
constexpr float kQc = 0.7f;
constexpr float kPc = 0.4f;
constexpr float kPt = 0.95f;
constexpr float kQf = 0.5f;
constexpr double kFeatureWidthDeg = 0.082;

// --- Colour spaces. XYZ is relative to the white of the display: (1, 1, 1) is that white.
// ---------

// Rows are those of linear Rec.709 to CIE XYZ, divided by their sums.
Color xyz_from_rgb(const Color& rgb) {
  constexpr float kX = 10135552.0f + 8788810.0f + 4435075.0f;
  constexpr float kY = 2613072.0f + 8788810.0f + 887015.0f;
  constexpr float kZ = 1425312.0f + 8788810.0f + 70074185.0f;
  return {10135552.0f / kX * rgb[0] + 8788810.0f / kX * rgb[1] + 4435075.0f / kX * rgb[2],
          2613072.0f / kY * rgb[0] + 8788810.0f / kY * rgb[1] + 887015.0f / kY * rgb[2],
          1425312.0f / kZ * rgb[0] + 8788810.0f / kZ * rgb[1] + 70074185.0f / kZ * rgb[2]};
}

// The inverse: CIE XYZ to linear Rec.709, after the white was multiplied back in.
Color rgb_from_xyz(const Color& xyz) {
  const float x = 0.950428545f * xyz[0];
  const float y = xyz[1];
  const float z = 1.088900371f * xyz[2];
  return {3.241003275f * x - 1.537398934f * y - 0.498615861f * z,
          -0.969224334f * x + 1.875930071f * y + 0.041554224f * z,
          0.055639423f * x - 0.204011202f * y + 1.057148933f * z};
}

// CIELAB, chroma scaled by lightness: the Hunt effect, by which dark colours look less colourful.
Color hunt_lab_from_rgb(const Color& rgb) {
  constexpr float kDelta = 6.0f / 29.0f;
  const auto compress = [](float t) {
    return t > kDelta * kDelta * kDelta ? std::cbrt(t)
                                        : t / (3.0f * kDelta * kDelta) + 4.0f / 29.0f;
  };
  const Color xyz = xyz_from_rgb(rgb);
  const float x = compress(xyz[0]);
  const float y = compress(xyz[1]);
  const float z = compress(xyz[2]);
  const float lightness = 116.0f * y - 16.0f;
  const float hunt = 0.01f * lightness;
  return {lightness, hunt * 500.0f * (x - y), hunt * 200.0f * (y - z)};
}

float hyab(const Color& a, const Color& b) {
  const float da = a[1] - b[1];
  const float db = a[2] - b[2];
  return std::abs(a[0] - b[0]) + std::sqrt(da * da + db * db);
}

// YCxCz, linear in light, one plane for each.
struct Planes {
  ImageF y, cx, cz;
};

Planes ycxcz_from_rgb(const ImageF& image) {
  LUEUR_CHECK(image.channels == 1 || image.channels == 3 || image.channels == 4);
  const auto plane = [&] { return ImageF(image.width, image.height, 1); };
  Planes planes = {plane(), plane(), plane()};
  const size_t green = image.channels == 1 ? 0 : 1;
  const size_t blue = image.channels == 1 ? 0 : 2;
  for (size_t i = 0; i < planes.y.samples.size(); ++i) {
    const float* pixel = &image.samples[i * image.channels];
    const Color xyz = xyz_from_rgb({pixel[0], pixel[green], pixel[blue]});
    planes.y.samples[i] = 116.0f * xyz[1] - 16.0f;
    planes.cx.samples[i] = 500.0f * (xyz[0] - xyz[1]);
    planes.cz.samples[i] = 200.0f * (xyz[1] - xyz[2]);
  }
  return planes;
}

// --- Filters. --------------------------------------------------------------------------------

// One Gaussian a sqrt(pi/b) exp(-pi^2 r^2 / b) of the contrast sensitivity, r in degrees: HPG 2020
// table 1. As a product of two filters, each has the root of the amplitude.
struct Sensitivity {
  double a, b;
};
constexpr Sensitivity kY = {1.0, 0.0047};
constexpr Sensitivity kCx = {1.0, 0.0053};
constexpr Sensitivity kCz1 = {34.1, 0.04};
constexpr Sensitivity kCz2 = {13.5, 0.025};

std::vector<double> sensitivity_filter(const Sensitivity& s, double pixels_per_degree) {
  constexpr double kPi = std::numbers::pi;
  // Three standard deviations of the widest.
  const int radius =
      static_cast<int>(std::ceil(3.0 * std::sqrt(kCz1.b / (2.0 * kPi * kPi)) * pixels_per_degree));
  std::vector<double> filter;
  for (int i = -radius; i <= radius; ++i) {
    const double r_deg = i / pixels_per_degree;
    filter.push_back(std::sqrt(s.a * std::sqrt(kPi / s.b)) *
                     std::exp(-kPi * kPi * r_deg * r_deg / s.b));
  }
  return filter;
}

double sum_of(const std::vector<double>& filter) {
  double sum = 0.0;
  for (const double weight : filter) sum += weight;
  return sum;
}

std::vector<float> divided(const std::vector<double>& filter, double divisor) {
  std::vector<float> result;
  for (const double weight : filter) result.push_back(static_cast<float>(weight / divisor));
  return result;
}

// Positive and negative weights are scaled apart.
std::vector<float> balanced(const std::vector<double>& filter) {
  double positive = 0.0, negative = 0.0;
  for (const double weight : filter) (weight > 0.0 ? positive : negative) += std::abs(weight);
  std::vector<float> result;
  for (const double weight : filter)
    result.push_back(static_cast<float>(weight / (weight > 0.0 ? positive : negative)));
  return result;
}

ImageF filtered(const ImageF& plane, std::span<const float> along_x,
                std::span<const float> along_y) {
  return filtered_along_y(filtered_along_x(plane, along_x), along_y);
}

// --- The two differences. ------------------------------------------------------------------------

// The picture as the eye resolves it, in YCxCz.
Planes seen(const Planes& picture, const FlipFilters& filters) {
  Planes result = {filtered(picture.y, filters.y, filters.y),
                   filtered(picture.cx, filters.cx, filters.cx),
                   filtered(picture.cz, filters.cz1, filters.cz1)};
  const ImageF cz2 = filtered(picture.cz, filters.cz2, filters.cz2);
  for (size_t i = 0; i < cz2.samples.size(); ++i) result.cz.samples[i] += cz2.samples[i];
  return result;
}

Color hunt_lab_at(const Planes& planes, size_t i) {
  const float y = (planes.y.samples[i] + 16.0f) / 116.0f;
  Color rgb =
      rgb_from_xyz({y + planes.cx.samples[i] / 500.0f, y, y - planes.cz.samples[i] / 200.0f});
  for (float& channel : rgb) channel = std::clamp(channel, 0.0f, 1.0f);
  return hunt_lab_from_rgb(rgb);
}

// In [0, 1]: distances up to the knee kPc take the range up to kPt, all beyond share the rest.
ImageF color_difference(const Planes& test, const Planes& reference) {
  // The largest distance of two colours of the display is that of green and blue.
  const float largest = std::pow(
      hyab(hunt_lab_from_rgb({0.0f, 1.0f, 0.0f}), hunt_lab_from_rgb({0.0f, 0.0f, 1.0f})), kQc);
  const float knee = kPc * largest;
  ImageF map(test.y.width, test.y.height, 1);
  for (size_t i = 0; i < map.samples.size(); ++i) {
    const float distance = std::pow(hyab(hunt_lab_at(test, i), hunt_lab_at(reference, i)), kQc);
    map.samples[i] = distance < knee ? distance * kPt / knee
                                     : kPt + (distance - knee) / (largest - knee) * (1.0f - kPt);
  }
  return map;
}

// How much of an edge and how much of a point each pixel is: lengths of the gradient and of the
// second derivatives along x and y, of the achromatic channel in [0, 1].
struct Features {
  ImageF edge, point;
};

ImageF length_of(const ImageF& a, const ImageF& b) {
  ImageF result = a;
  for (size_t i = 0; i < result.samples.size(); ++i)
    result.samples[i] = std::sqrt(a.samples[i] * a.samples[i] + b.samples[i] * b.samples[i]);
  return result;
}

Features features_of(const ImageF& y, const FlipFilters& filters) {
  ImageF grey = y;
  for (float& value : grey.samples) value = (value + 16.0f) / 116.0f;
  const ImageF blurred = filtered_along_x(grey, filters.gaussian);
  return {length_of(filtered(grey, filters.edge, filters.gaussian),
                    filtered_along_y(blurred, filters.edge)),
          length_of(filtered(grey, filters.point, filters.gaussian),
                    filtered_along_y(blurred, filters.point))};
}

}  // namespace

FlipFilters flip_filters(float pixels_per_degree) {
  const auto ppd = static_cast<double>(pixels_per_degree);
  FlipFilters filters;
  const auto normalized = [&](const Sensitivity& s) {
    const std::vector<double> filter = sensitivity_filter(s, ppd);
    return divided(filter, sum_of(filter));
  };
  filters.y = normalized(kY);
  filters.cx = normalized(kCx);
  const std::vector<double> cz1 = sensitivity_filter(kCz1, ppd);
  const std::vector<double> cz2 = sensitivity_filter(kCz2, ppd);
  const double cz_sum = std::hypot(sum_of(cz1), sum_of(cz2));  // both axes of both add up to 1
  filters.cz1 = divided(cz1, cz_sum);
  filters.cz2 = divided(cz2, cz_sum);

  const double sigma_px = 0.5 * kFeatureWidthDeg * ppd;
  const int radius = static_cast<int>(std::ceil(3.0 * sigma_px));
  std::vector<double> gaussian, edge, point;
  for (int i = -radius; i <= radius; ++i) {
    const double r = i / sigma_px;
    gaussian.push_back(std::exp(-0.5 * r * r));
    edge.push_back(-i * gaussian.back());
    point.push_back((r * r - 1.0) * gaussian.back());
  }
  filters.gaussian = divided(gaussian, sum_of(gaussian));
  filters.edge = balanced(edge);
  filters.point = balanced(point);
  return filters;
}

ImageF flip_map(const ImageF& test, const ImageF& reference, float pixels_per_degree) {
  LUEUR_CHECK_OP(test.width, ==, reference.width);
  LUEUR_CHECK_OP(test.height, ==, reference.height);
  const FlipFilters filters = flip_filters(pixels_per_degree);
  const Planes t = ycxcz_from_rgb(test);
  const Planes r = ycxcz_from_rgb(reference);
  ImageF map = color_difference(seen(t, filters), seen(r, filters));

  const Features features_t = features_of(t.y, filters);
  const Features features_r = features_of(r.y, filters);
  for (size_t i = 0; i < map.samples.size(); ++i) {
    const float edge = std::abs(features_t.edge.samples[i] - features_r.edge.samples[i]);
    const float point = std::abs(features_t.point.samples[i] - features_r.point.samples[i]);
    const float feature = std::pow(std::max(edge, point) / std::numbers::sqrt2_v<float>, kQf);
    map.samples[i] = std::pow(map.samples[i], 1.0f - feature);
  }
  return map;
}

}  // namespace lueur
