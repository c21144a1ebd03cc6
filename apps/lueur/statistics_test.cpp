// SPDX-License-Identifier: MIT
#include "statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lueur::cli {
namespace {

using Values = std::vector<double>;

// Sums of a few numbers near 1 in double precision.
constexpr double kRounding = 1e-12;

// y = f(x) for each x.
template <class Function>
Values map(const Values& x, Function f) {
  Values y;
  for (const double value : x) y.push_back(f(value));
  return y;
}

TEST(Statistics, DistributionOfOneAndOfMany) {
  const Distribution one = distribution({3.0});
  for (const double value :
       {one.least, one.lower_quartile, one.median, one.upper_quartile, one.most})
    EXPECT_EQ(value, 3.0);
  const Distribution odd = distribution({50, 10, 40, 20, 30});
  EXPECT_EQ(odd.least, 10);
  EXPECT_EQ(odd.lower_quartile, 20);
  EXPECT_EQ(odd.median, 30);
  EXPECT_EQ(odd.upper_quartile, 40);
  EXPECT_EQ(odd.most, 50);
  // Between two values the quartiles are interpolated: places 0.75, 1.5 and 2.25 of 0 to 3.
  const Distribution even = distribution({4, 1, 2, 3});
  EXPECT_EQ(even.lower_quartile, 1.75);
  EXPECT_EQ(even.median, 2.5);
  EXPECT_EQ(even.upper_quartile, 3.25);
}

// Times 2 and 6 in rounds that are slowed down by 1, 4 and 10, and one outlier. Plain medians are 8
// and 24, but 20 and 24 with the outlier.
TEST(Statistics, MediansInTurnIgnoreSlowRounds) {
  const auto even = medians_in_turn({{2, 8, 20}, {6, 24, 60}});
  EXPECT_NEAR(even[0], 8.0, 10 * kRounding);
  EXPECT_NEAR(even[1], 24.0, 10 * kRounding);
  const auto outlier = medians_in_turn({{2, 200, 20}, {6, 24, 60}});
  EXPECT_NEAR(outlier[1] / outlier[0], 3.0, 10 * kRounding);
}

TEST(Statistics, PowerLawIsRecovered) {
  const Values x = {8, 16, 32, 64, 128, 256};
  for (const double exponent : {-1.0, 0.5, 1.0, 2.0}) {
    const auto law = fit_power_law(x, map(x, [&](double v) { return 3 * std::pow(v, exponent); }));
    ASSERT_TRUE(law);
    EXPECT_NEAR(law->exponent, exponent, kRounding);
    EXPECT_NEAR(law->factor, 3.0, 10 * kRounding);
    // Squares of the residuals are lost in rounding, their root is not.
    EXPECT_NEAR(*law->exponent_error, 0.0, 1e-7);
    EXPECT_NEAR(*law->r_squared, 1.0, kRounding);
  }
}

// Logarithms of x are 0, 1, 2, 3 times log 2, those of y off the law by +d, -d, -d, +d: the slope
// stays, the residuals are d each, and the error is sqrt(4 d^2 / 2 / (5 log^2 2)).
TEST(Statistics, NoiseWidensTheError) {
  const double d = 0.1;
  const Values x = {1, 2, 4, 8};
  Values y = x;
  for (size_t i = 0; i < y.size(); ++i) y[i] *= std::exp(i == 0 || i == 3 ? d : -d);
  const auto law = fit_power_law(x, y);
  ASSERT_TRUE(law);
  EXPECT_NEAR(law->exponent, 1.0, kRounding);
  EXPECT_NEAR(*law->exponent_error, d * std::sqrt(2.0 / 5.0) / std::log(2.0), kRounding);
  const double varied = 5 * std::log(2.0) * std::log(2.0);
  EXPECT_NEAR(*law->r_squared, varied / (varied + 4 * d * d), kRounding);
}

TEST(Statistics, ConstantTimesHaveExponentZero) {
  const Values x = {1, 10, 100}, y = {7, 7, 7};
  const auto law = fit_power_law(x, y);
  ASSERT_TRUE(law);
  EXPECT_NEAR(law->exponent, 0.0, kRounding);
  EXPECT_NEAR(law->factor, 7.0, 10 * kRounding);
  EXPECT_FALSE(law->r_squared);  // nothing varies that could be explained
}

TEST(Statistics, TwoPointsHaveAnExponentWithoutError) {
  const auto law = fit_power_law(Values{1, 4}, Values{5, 10});
  ASSERT_TRUE(law);
  EXPECT_NEAR(law->exponent, 0.5, kRounding);
  EXPECT_FALSE(law->exponent_error);
}

TEST(Statistics, WhatHasNoExponent) {
  EXPECT_FALSE(fit_power_law(Values{}, Values{}));
  EXPECT_FALSE(fit_power_law(Values{2}, Values{3}));
  EXPECT_FALSE(fit_power_law(Values{2, 2}, Values{3, 4}));
  EXPECT_FALSE(fit_power_law(Values{1, 2, 3}, Values{1, 0, 3}));
  EXPECT_FALSE(fit_power_law(Values{-1, 2}, Values{1, 2}));
}

TEST(Statistics, LineSeparatesTheConstantPart) {
  const Values x = {8, 16, 32, 64};
  const Values y = map(x, [](double v) { return 5 + 0.25 * v; });
  const auto line = fit_line(x, y);
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->constant, 5.0, kRounding);
  EXPECT_NEAR(line->slope, 0.25, kRounding);
  EXPECT_NEAR(*line->r_squared, 1.0, kRounding);
  // As a power law the same series grows less than in proportion.
  EXPECT_LT(fit_power_law(x, y)->exponent, 1.0);
  EXPECT_FALSE(fit_line(Values{1, 1}, Values{2, 3}));
  EXPECT_EQ(fit_line(Values{0, 2}, Values{-1, 3})->slope, 2.0);
}

}  // namespace
}  // namespace lueur::cli
