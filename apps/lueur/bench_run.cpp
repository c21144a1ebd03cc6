// SPDX-License-Identifier: MIT
#include "bench_run.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <ctime>

#include "base/check.h"
#include "base/try.h"
#include "lueur/hierarchical.h"

namespace lueur::cli {
namespace {

double process_cpu_ms() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

double median(std::vector<double> values) {
  LUEUR_CHECK(!values.empty());
  std::sort(values.begin(), values.end());
  const size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

// The median over the frames of what `of` takes from each.
template <class Of>
double median_of(const std::vector<FrameTimes>& frames, Of of) {
  std::vector<double> values;
  values.reserve(frames.size());
  for (const FrameTimes& frame : frames) values.push_back(of(frame));
  return median(std::move(values));
}

double ms_of_pass(const FrameTimes& frame, const std::string& name) {
  for (const PassTime& pass : frame.passes)
    if (pass.name == name) return pass.gpu_ms;
  return 0;
}

}  // namespace

Result<FrameTimes> time_frame(Session& session, Candidate& candidate) {
  FrameTimes times;
  const double cpu_start_ms = process_cpu_ms();
  const auto start = std::chrono::steady_clock::now();
  LUEUR_TRY(record, render_frame(session, *candidate.renderer, candidate.shot,
                                 candidate.technique.technique.get(), {}));
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
  times.wall_ms = taken.count();
  times.cpu_ms = process_cpu_ms() - cpu_start_ms;
  times.passes = std::move(record.passes);
  return times;
}

BenchSummary summarize(const std::vector<FrameTimes>& frames, const Candidate& candidate) {
  BenchSummary summary;
  const std::string prefix = candidate.technique.name() + ".";
  const bool has_technique = candidate.technique.info != nullptr;
  for (const PassTime& pass : frames.front().passes) {
    PassSummary row{pass.name, 0, 0, {}};
    row.gpu_ms = median_of(frames, [&](const FrameTimes& f) { return ms_of_pass(f, pass.name); });
    row.cpu_ms = median_of(frames, [&](const FrameTimes& f) {
      return ms_of_pass(f, pass.name) * f.cpu_ms / f.wall_ms;
    });
    row.samples = samples_of(pass.name, candidate.technique, candidate.shot.extent);
    summary.passes.push_back(std::move(row));
  }
  summary.technique_ms = median_of(frames, [&](const FrameTimes& f) {
    return has_technique ? total_ms(f.passes, prefix) : 0.0;
  });
  summary.frame_ms = median_of(frames, [](const FrameTimes& f) { return total_ms(f.passes, ""); });
  summary.wall_ms = median_of(frames, [](const FrameTimes& f) { return f.wall_ms; });
  summary.cpu_ms = median_of(frames, [](const FrameTimes& f) { return f.cpu_ms; });
  return summary;
}

std::optional<uint64_t> samples_of(const std::string& pass, const ChosenTechnique& technique,
                                   Extent size) {
  constexpr std::string_view kGather = "hierarchical.gather@";
  if (technique.name() != "hierarchical" || !pass.starts_with(kGather)) return std::nullopt;
  const auto& settings = *static_cast<const HierarchicalSettings*>(technique.technique->settings());
  if (settings.sampling == HierarchicalSettings::Sampling::every_pixel) return std::nullopt;
  uint32_t level = 0;
  std::from_chars(pass.data() + kGather.size(), pass.data() + pass.size(), level);
  // A pixel of level 0 covers 1, 2 or 4 of the picture's a side, one of each next level twice that.
  const uint32_t factor = 1u << (static_cast<uint32_t>(settings.start) + level);
  return uint64_t{divide_up(size.width, factor)} * divide_up(size.height, factor) *
         samples_at_level(settings, level);
}

}  // namespace lueur::cli
