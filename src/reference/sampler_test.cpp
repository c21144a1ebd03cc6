// SPDX-License-Identifier: MIT
// What the random numbers promise: strata, uniformity, independence.
#include "reference/sampler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <vector>

namespace lueur::reference {
namespace {

// The pair number `pair` of sample `index`.
glm::vec2 pair_of(uint32_t seed, uint32_t index, int pair = 0) {
  Sampler sampler(seed, index);
  glm::vec2 u = sampler.next_2d();
  for (int k = 0; k < pair; ++k) u = sampler.next_2d();
  return u;
}

// Chance numbers for the tests, from another family of generators than the one under test.
std::vector<uint32_t> some_seeds(size_t count) {
  std::mt19937 engine(20240607);
  std::vector<uint32_t> seeds(count);
  for (uint32_t& seed : seeds) seed = static_cast<uint32_t>(engine());
  seeds[0] = 0;
  return seeds;
}

// (0, 2)-sequences in base 2: every aligned block of 2^m samples has one in each of the 2^m boxes
// of every shape 2^-a x 2^-(m - a).
TEST(Sampler, EveryAlignedBlockIsStratified) {
  for (const uint32_t seed : some_seeds(8)) {
    for (const int pair : {0, 1, 5}) {
      for (int m = 0; m <= 10; ++m) {
        const uint32_t count = 1u << m;
        for (const uint32_t block : {0u, 1u, 2u, 77u, (1u << 20) / count - 1}) {
          std::vector<glm::vec2> points;
          for (uint32_t i = 0; i < count; ++i)
            points.push_back(pair_of(seed, block * count + i, pair));
          for (int a = 0; a <= m; ++a) {
            std::set<std::pair<uint32_t, uint32_t>> boxes;
            for (const glm::vec2& p : points)
              boxes.insert({static_cast<uint32_t>(p.x * static_cast<float>(1u << a)),
                            static_cast<uint32_t>(p.y * static_cast<float>(1u << (m - a)))});
            ASSERT_EQ(boxes.size(), count) << "seed " << seed << ", pair " << pair << ", block "
                                           << block << " of " << count << ", columns " << (1u << a);
          }
        }
      }
    }
  }
}

TEST(Sampler, NumbersAreBelowOne) {
  EXPECT_EQ(unit_float(0), 0.0f);
  EXPECT_LT(unit_float(UINT32_MAX), 1.0f);
}

// One sample over many seeds is uniform: chi-square over 64 boxes. With 63 degrees of freedom its
// mean is 63 and its deviation 11.2; 130 is exceeded with a probability of 1e-6, and there are 24
// tests.
TEST(Sampler, OneSampleIsUniformOverSeeds) {
  constexpr uint32_t kSeeds = 1u << 15;
  for (const uint32_t index : {0u, 1u, 2u, 7u, 100u, 65535u}) {
    for (const int pair : {0, 1, 2, 7}) {
      std::vector<int> boxes(64);
      for (uint32_t seed = 0; seed < kSeeds; ++seed) {
        const glm::vec2 u = pair_of(combined(seed, 3), index, pair);
        ++boxes[static_cast<size_t>(u.x * 8) * 8 + static_cast<size_t>(u.y * 8)];
      }
      double chi2 = 0;
      for (const int n : boxes) chi2 += (n - kSeeds / 64.0) * (n - kSeeds / 64.0) / (kSeeds / 64.0);
      EXPECT_LT(chi2, 130.0) << "index " << index << ", pair " << pair;
    }
  }
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  // Of uniform numbers: mean 1/2, variance 1/12.
  for (size_t i = 0; i < a.size(); ++i) sum += (a[i] - 0.5) * (b[i] - 0.5) * 12.0;
  return sum / static_cast<double>(a.size());
}

// Over seeds, the numbers of a path are independent: a correlation of n of them has the deviation
// 1 / sqrt(n), and five of it are exceeded once in 1.7 million.
TEST(Sampler, PairsAreIndependentOverSeeds) {
  constexpr uint32_t kSeeds = 1u << 15;
  constexpr int kPairs = 4;
  const double bound = 5.0 / std::sqrt(kSeeds);
  for (const uint32_t index : {0u, 1u, 63u, 4096u}) {
    std::vector<std::vector<double>> numbers(2 * kPairs + 1, std::vector<double>(kSeeds));
    for (uint32_t seed = 0; seed < kSeeds; ++seed) {
      Sampler sampler(combined(seed, 11), index);
      for (size_t pair = 0; pair < kPairs; ++pair) {
        const glm::vec2 u = sampler.next_2d();
        numbers[2 * pair][seed] = static_cast<double>(u.x);
        numbers[2 * pair + 1][seed] = static_cast<double>(u.y);
      }
      // The next sample's first number: independent but for the strata of the two, which makes it
      // the other half of [0, 1) whenever the index is even.
      numbers[2 * kPairs][seed] =
          static_cast<double>(pair_of(combined(seed, 11), index + 2, kPairs).x);
    }
    for (size_t a = 0; a < numbers.size(); ++a)
      for (size_t b = 0; b < a; ++b)
        EXPECT_LT(std::abs(correlation(numbers[a], numbers[b])), bound)
            << "numbers " << a << " and " << b << " of sample " << index;
  }
}

// Within one pixel, pairs of different numbers follow unrelated orders: no correlation over the
// samples. Stratified numbers scatter no more than random ones.
TEST(Sampler, PairsAreIndependentOverSamples) {
  constexpr uint32_t kSamples = 4096;
  for (const uint32_t seed : some_seeds(16)) {
    std::vector<std::vector<double>> numbers(6, std::vector<double>(kSamples));
    for (uint32_t i = 0; i < kSamples; ++i) {
      Sampler sampler(seed, i);
      for (size_t pair = 0; pair < 3; ++pair) {
        const glm::vec2 u = sampler.next_2d();
        numbers[2 * pair][i] = static_cast<double>(u.x);
        numbers[2 * pair + 1][i] = static_cast<double>(u.y);
      }
    }
    for (size_t a = 0; a < numbers.size(); ++a)
      for (size_t b = 0; b < a; ++b)
        EXPECT_LT(std::abs(correlation(numbers[a], numbers[b])), 5.0 / std::sqrt(kSamples))
            << "numbers " << a << " and " << b << ", seed " << seed;
  }
}

// What strata are for: the error of the mean of a smooth function falls faster than 1 / sqrt(n).
TEST(Sampler, SmoothFunctionsConvergeFasterThanAtRandom) {
  const auto error = [](uint32_t samples) {
    double squares = 0;
    constexpr uint32_t kSeeds = 64;
    for (uint32_t seed = 0; seed < kSeeds; ++seed) {
      double sum = 0;
      for (uint32_t i = 0; i < samples; ++i) {
        const glm::dvec2 u = pair_of(combined(seed, 5), i);
        sum += std::sin(3.0 * u.x) * std::exp(u.y);
      }
      const double exact = (1 - std::cos(3.0)) / 3.0 * (std::exp(1.0) - 1);
      squares += (sum / samples - exact) * (sum / samples - exact);
    }
    return std::sqrt(squares / kSeeds);
  };
  // At random 256 times the samples divide the error by 16, scrambled nets by about 256^1.5 = 4096.
  EXPECT_GT(error(4) / error(1024), 256.0);
}

}  // namespace
}  // namespace lueur::reference
