// SPDX-License-Identifier: MIT
#include "statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/check.h"

namespace lueur::cli {
namespace {

// The value at `share` of the way through sorted values.
double quantile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<size_t>(place);
  const size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], place - std::floor(place));
}

double mean(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// The logarithms, or nothing where one has none.
std::vector<double> logs(std::span<const double> values) {
  std::vector<double> result;
  for (const double value : values) {
    if (!(value > 0.0)) return {};
    result.push_back(std::log(value));
  }
  return result;
}

}  // namespace

Distribution distribution(std::vector<double> values) {
  LUEUR_CHECK(!values.empty());
  std::sort(values.begin(), values.end());
  return {values.front(), quantile(values, 0.25), quantile(values, 0.5), quantile(values, 0.75),
          values.back()};
}

std::vector<double> medians_in_turn(const std::vector<std::vector<double>>& times) {
  LUEUR_CHECK(!times.empty());
  std::vector<std::vector<double>> relative(times.size());  // logarithms
  std::vector<double> means;
  for (size_t round = 0; round < times.front().size(); ++round) {
    double sum = 0;
    for (const auto& row : times) sum += std::log(row[round]);
    means.push_back(sum / static_cast<double>(times.size()));
    for (size_t i = 0; i < times.size(); ++i)
      relative[i].push_back(std::log(times[i][round]) - means.back());
  }
  const double scale = distribution(means).median;
  std::vector<double> medians;
  medians.reserve(times.size());
  for (auto& row : relative)
    medians.push_back(std::exp(scale + distribution(std::move(row)).median));
  return medians;
}

std::optional<Line> fit_line(std::span<const double> x, std::span<const double> y) {
  LUEUR_CHECK(x.size() == y.size());
  if (x.size() < 2) return std::nullopt;
  const double mean_x = mean(x), mean_y = mean(y);
  double xx = 0, xy = 0, yy = 0;
  for (size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
    yy += (y[i] - mean_y) * (y[i] - mean_y);
  }
  if (xx == 0.0) return std::nullopt;
  Line line;
  line.slope = xy / xx;
  line.constant = mean_y - line.slope * mean_x;
  double residual = 0;
  for (size_t i = 0; i < x.size(); ++i) {
    const double miss = y[i] - line.constant - line.slope * x[i];
    residual += miss * miss;
  }
  if (yy > 0.0) line.r_squared = std::max(0.0, 1.0 - residual / yy);
  if (x.size() > 2)
    line.slope_error = std::sqrt(residual / (static_cast<double>(x.size() - 2) * xx));
  return line;
}

std::optional<PowerLaw> fit_power_law(std::span<const double> x, std::span<const double> y) {
  const std::vector<double> log_x = logs(x), log_y = logs(y);
  if (log_x.size() != x.size() || log_y.size() != y.size()) return std::nullopt;
  const std::optional<Line> line = fit_line(log_x, log_y);
  if (!line) return std::nullopt;
  return PowerLaw{std::exp(line->constant), line->slope, line->slope_error, line->r_squared};
}

}  // namespace lueur::cli
