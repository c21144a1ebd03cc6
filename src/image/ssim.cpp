// SPDX-License-Identifier: MIT
#include "image/ssim.h"

#include <cmath>
#include <vector>

#include "base/check.h"
#include "image/separable_filter.h"

namespace lueur {
namespace {

constexpr float kC1 = 0.01f * 0.01f;
constexpr float kC2 = 0.03f * 0.03f;

std::vector<float> window() {
  constexpr int kRadius = 5;
  constexpr double kSigma = 1.5;
  std::vector<float> weights;
  double sum = 0.0;
  for (int i = -kRadius; i <= kRadius; ++i) sum += std::exp(-0.5 * i * i / (kSigma * kSigma));
  for (int i = -kRadius; i <= kRadius; ++i)
    weights.push_back(static_cast<float>(std::exp(-0.5 * i * i / (kSigma * kSigma)) / sum));
  return weights;
}

ImageF product(const ImageF& a, const ImageF& b) {
  ImageF result = a;
  for (size_t i = 0; i < result.samples.size(); ++i) result.samples[i] *= b.samples[i];
  return result;
}

}  // namespace

ImageF ssim_map(const ImageF& test_luma, const ImageF& reference_luma) {
  LUEUR_CHECK_OP(test_luma.width, ==, reference_luma.width);
  LUEUR_CHECK_OP(test_luma.height, ==, reference_luma.height);
  const std::vector<float> weights = window();
  const auto windowed = [&](const ImageF& plane) {
    return filtered_along_y(filtered_along_x(plane, weights), weights);
  };
  const ImageF mean_t = windowed(test_luma);
  const ImageF mean_r = windowed(reference_luma);
  const ImageF mean_tt = windowed(product(test_luma, test_luma));
  const ImageF mean_rr = windowed(product(reference_luma, reference_luma));
  const ImageF mean_tr = windowed(product(test_luma, reference_luma));

  ImageF map(test_luma.width, test_luma.height, 1);
  for (size_t i = 0; i < map.samples.size(); ++i) {
    const float t = mean_t.samples[i];
    const float r = mean_r.samples[i];
    const float variances = (mean_tt.samples[i] - t * t) + (mean_rr.samples[i] - r * r);
    const float covariance = mean_tr.samples[i] - t * r;
    // SSIM (13)
    map.samples[i] = (2.0f * t * r + kC1) * (2.0f * covariance + kC2) /
                     ((t * t + r * r + kC1) * (variances + kC2));
  }
  return map;
}

}  // namespace lueur
