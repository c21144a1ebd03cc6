// SPDX-License-Identifier: MIT
// From many times to a few numbers, and from a series of them to a law. Pure functions.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace lueur::cli {

// Where the values lie. Quartiles are interpolated between neighbours, as the median is.
struct Distribution {
  double least = 0;
  double lower_quartile = 0;
  double median = 0;
  double upper_quartile = 0;
  double most = 0;
};

// Of at least one value.
Distribution distribution(std::vector<double> values);

// Medians of times that were taken in turn, `times[i][round]`, all of them positive. Each time is
// taken relative to the geometric mean of its round, so that what slows a whole round down does not
// count; the median of those means gives the scale back.
std::vector<double> medians_in_turn(const std::vector<std::vector<double>>& times);

// y = factor * x^exponent, by least squares of log y on log x.
struct PowerLaw {
  double factor = 0;
  double exponent = 0;
  std::optional<double> exponent_error;  // standard error; none for two points
  std::optional<double> r_squared;       // of log y; none where y does not vary
};

// y = constant + slope * x, by least squares.
struct Line {
  double constant = 0;
  double slope = 0;
  std::optional<double> slope_error;
  std::optional<double> r_squared;
};

// Fit the points (x[i], y[i]). None with fewer than two different x, and for a power law where an x
// or y is not positive. Both spans are of one length.
std::optional<PowerLaw> fit_power_law(std::span<const double> x, std::span<const double> y);
std::optional<Line> fit_line(std::span<const double> x, std::span<const double> y);

}  // namespace lueur::cli
