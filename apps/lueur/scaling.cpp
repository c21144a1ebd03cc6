// SPDX-License-Identifier: MIT
#include "scaling.h"

#include <algorithm>
#include <cmath>

#include "arguments.h"
#include "base/check.h"
#include "base/try.h"

namespace lueur::cli {
namespace {

// Shares of the side of --size.
constexpr double kSideShares[] = {0.25, 0.375, 0.5, 0.75, 1.0, 1.5};

std::string text_of(Extent size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

std::vector<std::string> default_values(const std::string& of, Extent size) {
  if (of == "triangles") return {"10000", "30000", "100000", "300000", "1000000"};
  if (of == "samples") return {"8", "16", "32", "64", "128", "256"};
  if (of == "levels") return {"1", "2", "3", "4", "5", "6", "7", "8"};
  std::vector<std::string> values;
  if (of != "pixels") return values;
  for (const double share : kSideShares) {
    const auto side = [&](uint32_t full) {
      return static_cast<uint32_t>(std::max(std::lround(share * full), 1L));
    };
    values.push_back(text_of({side(size.width), side(size.height)}));
  }
  return values;
}

Error refuse(const Scale& scale, const std::string& what) {
  return {ErrorKind::usage, scale.flag + " " + what};
}

const SettingInfo* numeric_setting(const ChosenTechnique& technique, const std::string& name) {
  if (!technique.info) return nullptr;
  for (const SettingInfo& row : technique.info->settings)
    if (row.name == name && (row.kind == SettingKind::integer || row.kind == SettingKind::real))
      return &row;
  return nullptr;
}

double x_of(const Scale& scale, const Candidate& candidate) {
  const Extent size = candidate.shot.extent;
  if (scale.of == "pixels") return static_cast<double>(uint64_t{size.width} * size.height);
  if (scale.of == "triangles") return static_cast<double>(candidate.scene->triangles);
  const SettingInfo* row = numeric_setting(candidate.technique, scale.of);
  LUEUR_CHECK(row != nullptr);
  return row->get(candidate.technique.technique->settings());
}

// Fits what takes `ms_of` a frame, at those values where it takes any.
template <class MsOf>
void add_fit(const std::string& group, std::span<const double> x,
             std::span<const std::vector<FrameTimes>> rounds, MsOf ms_of,
             std::vector<ScaleFit>& fits) {
  std::vector<double> x_taken;
  std::vector<std::vector<double>> times;
  for (size_t i = 0; i < x.size(); ++i) {
    std::vector<double> ms;
    for (const FrameTimes& frame : rounds[i]) ms.push_back(ms_of(frame));
    if (!std::all_of(ms.begin(), ms.end(), [](double t) { return t > 0.0; })) continue;
    x_taken.push_back(x[i]);
    times.push_back(std::move(ms));
  }
  if (x_taken.size() < 2) return;
  const std::vector<double> ms = medians_in_turn(times);
  fits.push_back({group, ms.front(), ms.back(), fit_power_law(x_taken, ms), fit_line(x_taken, ms)});
}

// The groups of all candidates, each once.
std::vector<std::string> all_groups(std::span<const std::vector<FrameTimes>> rounds) {
  std::vector<std::string> names;
  for (const auto& frames : rounds)
    for (const std::string& name : group_names(frames.front()))
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  return names;
}

}  // namespace

Result<Scale> parse_scale(const std::string& flag, const std::string& text, Extent size) {
  const size_t equals = text.find('=');
  Scale scale{flag, text.substr(0, equals), {}};
  scale.values = equals == std::string::npos ? default_values(scale.of, size)
                                             : split(text.substr(equals + 1), ',');
  if (scale.values.empty())
    return refuse(scale, "'" + text +
                             "': without values there is pixels, triangles, samples, levels; give "
                             "values, such as radius=10,20,40");
  for (size_t i = 0; i < scale.values.size(); ++i)
    if (std::count(scale.values.begin(), scale.values.end(), scale.values[i]) > 1)
      return refuse(scale, "'" + text + "': " + scale.values[i] + " is given twice; give it once");
  return scale;
}

Result<CandidateRequest> at_value(const Scale& scale, const std::string& value,
                                  const CandidateRequest& base) {
  CandidateRequest request{base.label,           base.scene,       base.size,
                           copy(base.technique), base.environment, base.limits};
  if (scale.of == "pixels") {
    LUEUR_TRY(size, parse_size(scale.flag, value));
    request.size = size;
  } else if (scale.of == "triangles") {
    if (base.scene != "atrium")
      return refuse(scale, "'" + value + "': triangles go with --scene atrium, not with '" +
                               base.scene + "'; leave one of them out");
    LUEUR_TRY(count, parse_count(scale.flag, value, 1, UINT32_MAX));
    request.scene = "atrium:triangles=" + std::to_string(count);
  } else {
    if (!numeric_setting(base.technique, scale.of))
      return refuse(scale, "'" + scale.of + "': neither pixels nor triangles nor a setting of '" +
                               base.technique.name() + "' that is a number");
    LUEUR_TRY_VOID(change(request.technique, scale.flag, scale.of + "=" + value));
  }
  request.label += ", " + scale.of + " " + value;
  return request;
}

std::vector<Series> fit_series(const Scale& scale, std::span<const std::string> techniques,
                               std::span<const Candidate> candidates, const Rounds& rounds) {
  const size_t count = scale.values.size();
  LUEUR_CHECK(candidates.size() == techniques.size() * count);
  LUEUR_CHECK(rounds.size() == candidates.size());
  std::vector<Series> all;
  for (const std::string& technique : techniques) {
    Series series{technique, all.size() * count, {}, {}};
    for (size_t i = 0; i < count; ++i)
      series.x.push_back(x_of(scale, candidates[series.first + i]));
    const auto own_rounds = std::span(rounds).subspan(series.first, count);
    const auto add = [&](const std::string& name, auto ms_of) {
      add_fit(name, series.x, own_rounds, ms_of, series.fits);
    };
    const ChosenTechnique& chosen = candidates[series.first].technique;
    add("technique", [&](const FrameTimes& f) { return technique_ms(f.together, chosen); });
    add("all passes", [](const FrameTimes& f) { return total_ms(f.together, ""); });
    for (const std::string& group : all_groups(own_rounds))
      add(group, [&](const FrameTimes& f) { return group_ms(f, group); });
    all.push_back(std::move(series));
  }
  return all;
}

}  // namespace lueur::cli
