// SPDX-License-Identifier: MIT
#include "outside/agreement.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/check.h"

namespace lueur {
namespace {

constexpr uint32_t kSquare = 8;  // pixels a side

// Sums over some pixels. The channels of a pixel share their paths, so they are one sample.
struct Sums {
  double first = 0, second = 0;
  double squared_difference = 0, variance = 0;  // of single channels
  double variance_of_sum = 0;                   // of `first` - `second`

  void add_pixel(const TwoSeeds& f, const TwoSeeds& s, uint32_t x, uint32_t y) {
    double first_error = 0, second_error = 0;
    for (uint32_t c = 0; c < 3; ++c) {
      const double fa = f.a.at(x, y, c), fb = f.b.at(x, y, c);
      const double sa = s.a.at(x, y, c), sb = s.b.at(x, y, c);
      const double difference = 0.5 * (fa + fb) - 0.5 * (sa + sb);
      first += 0.5 * (fa + fb);
      second += 0.5 * (sa + sb);
      squared_difference += difference * difference;
      variance += 0.25 * ((fa - fb) * (fa - fb) + (sa - sb) * (sa - sb));
      first_error += 0.5 * (fa - fb);
      second_error += 0.5 * (sa - sb);
    }
    variance_of_sum += first_error * first_error + second_error * second_error;
  }
};

}  // namespace

Agreement agreement(const TwoSeeds& first, const TwoSeeds& second) {
  const uint32_t width = first.a.width, height = first.a.height;
  LUEUR_CHECK(width % kSquare == 0 && height % kSquare == 0);
  for (const ImageF* image : {&first.a, &first.b, &second.a, &second.b})
    LUEUR_CHECK(image->width == width && image->height == height && image->channels == 3);

  Sums all;
  double sum_z2 = 0, greatest = 0;
  uint32_t squares = 0;
  for (uint32_t top = 0; top < height; top += kSquare) {
    for (uint32_t left = 0; left < width; left += kSquare) {
      Sums square;
      for (uint32_t y = top; y < top + kSquare; ++y) {
        for (uint32_t x = left; x < left + kSquare; ++x) {
          square.add_pixel(first, second, x, y);
          all.add_pixel(first, second, x, y);
        }
      }
      if (!(square.variance_of_sum > 0)) continue;
      const double z = (square.first - square.second) / std::sqrt(square.variance_of_sum);
      sum_z2 += z * z;
      greatest = std::max(greatest, std::abs(z));
      ++squares;
    }
  }
  const double count = 3.0 * width * height, mean = all.second / count;
  Agreement a;
  a.mean = all.first / count;
  a.bias = (all.first - all.second) / all.second;
  a.standard_error = std::sqrt(all.variance_of_sum) / all.second;
  a.rmse = std::sqrt(all.squared_difference / count) / mean;
  a.noise = std::sqrt(all.variance / count) / mean;
  a.square_z = squares > 0 ? std::sqrt(sum_z2 / squares) : 0.0;
  a.greatest_square_z = greatest;
  return a;
}

std::string to_string(const Agreement& a) {
  char text[200];
  std::snprintf(text, sizeof text,
                "mean %.4f, bias %+.4f %% +- %.4f %%, RMSE %.3f %% (noise alone %.3f %%), "
                "squares: z %.2f, at most %.2f",
                a.mean, 100 * a.bias, 100 * a.standard_error, 100 * a.rmse, 100 * a.noise,
                a.square_z, a.greatest_square_z);
  return text;
}

}  // namespace lueur
