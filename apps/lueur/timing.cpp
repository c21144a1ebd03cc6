// SPDX-License-Identifier: MIT
#include "timing.h"

#include <algorithm>
#include <chrono>
#include <ctime>

#include "base/check.h"
#include "base/try.h"

namespace lueur::cli {
namespace {

using Frames = std::vector<FrameTimes>;

double process_cpu_ms() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

Result<FrameTimes> time_frames(Session& session, Candidate& candidate) {
  FrameTimes times;
  session.context.set_timers(Timers::passes);
  LUEUR_TRY(by_pass, render_candidate(session, candidate, {}));
  times.passes = std::move(by_pass.passes);
  session.context.set_timers(Timers::together);
  const double cpu_start_ms = process_cpu_ms();
  const auto start = std::chrono::steady_clock::now();
  LUEUR_TRY(record, render_candidate(session, candidate, {}));
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
  times.wall_ms = taken.count();
  times.cpu_ms = process_cpu_ms() - cpu_start_ms;
  times.together = std::move(record.passes);
  return times;
}

// Over the frames, what `of` takes from each.
template <class Of>
Distribution over(const Frames& frames, Of of) {
  std::vector<double> values;
  values.reserve(frames.size());
  for (const FrameTimes& frame : frames) values.push_back(of(frame));
  return distribution(std::move(values));
}

// The same with `ms_of`, a GPU time, as a share of the frame's CPU time.
template <class MsOf>
double cpu_share(const Frames& frames, MsOf ms_of) {
  return over(frames, [&](const FrameTimes& f) { return ms_of(f) * f.cpu_ms / f.wall_ms; }).median;
}

template <class MsOf>
PassSummary row(const std::string& name, const Frames& frames, MsOf ms_of) {
  return {name, over(frames, ms_of), cpu_share(frames, ms_of), {}};
}

double frame_ms(const FrameTimes& frame) {
  return total_ms(frame.together, "");
}

double ms_of(const std::vector<PassTime>& passes, const ChosenTechnique& technique,
             PassOwner owner) {
  double ms = 0;
  for (const PassTime& pass : passes)
    if (owner_of(pass.name, technique) == owner) ms += pass.gpu_ms;
  return ms;
}

// All frames of a candidate have the same passes, each name once.
void summarize_passes(const Frames& frames, const Candidate& candidate, Summary& summary) {
  const std::vector<PassTime>& passes = frames.front().passes;
  for (size_t i = 0; i < passes.size(); ++i) {
    summary.passes.push_back(
        row(passes[i].name, frames, [&](const FrameTimes& f) { return f.passes[i].gpu_ms; }));
    summary.passes.back().samples = samples_of(passes[i].name, candidate);
  }
  for (const std::string& group : group_names(frames.front()))
    summary.groups.push_back(
        row(group, frames, [&](const FrameTimes& f) { return group_ms(f, group); }));
}

// Median over the rounds; none where the first candidate takes no time.
template <class MsOf, class FirstMsOf>
std::optional<double> ratio(const Frames& frames, const Frames& first, MsOf ms_of,
                            FirstMsOf first_ms_of) {
  std::vector<double> ratios;
  for (size_t round = 0; round < frames.size(); ++round) {
    const double first_ms = first_ms_of(first[round]);
    if (!(first_ms > 0.0)) return std::nullopt;
    ratios.push_back(ms_of(frames[round]) / first_ms);
  }
  return distribution(std::move(ratios)).median;
}

Result<Rounds> timed_rounds(Session& session, std::span<Candidate> candidates, uint32_t rounds) {
  Rounds times(candidates.size());
  const uint32_t warm_up = warm_up_frames(rounds);
  for (uint32_t round = 0; round < warm_up + rounds; ++round) {
    for (size_t i = 0; i < candidates.size(); ++i) {
      if (round < warm_up) {
        LUEUR_TRY_VOID(render_candidate(session, candidates[i], {}));
        continue;
      }
      LUEUR_TRY(taken, time_frames(session, candidates[i]));
      times[i].push_back(std::move(taken));
    }
  }
  return times;
}

}  // namespace

Result<Rounds> time_in_turn(Session& session, std::span<Candidate> candidates, uint32_t rounds) {
  auto times = timed_rounds(session, candidates, rounds);
  session.context.set_timers(Timers::passes);
  return times;
}

std::vector<Summary> summarize(const Rounds& rounds, std::span<const Candidate> candidates) {
  LUEUR_CHECK(rounds.size() == candidates.size());
  std::vector<Summary> summaries;
  for (size_t i = 0; i < candidates.size(); ++i) {
    const Frames& frames = rounds[i];
    const auto of_technique = [&](const FrameTimes& f) {
      return technique_ms(f.together, candidates[i].technique);
    };
    Summary summary;
    summarize_passes(frames, candidates[i], summary);
    summary.technique_ms = over(frames, of_technique);
    summary.technique_cpu_ms = cpu_share(frames, of_technique);
    summary.host_ms = over(
        frames, [&](const FrameTimes& f) { return host_ms(f.together, candidates[i].technique); });
    summary.frame_ms = over(frames, frame_ms);
    summary.wall_ms = over(frames, [](const FrameTimes& f) { return f.wall_ms; });
    summary.cpu_ms = over(frames, [](const FrameTimes& f) { return f.cpu_ms; });
    const auto of_first = [&](const FrameTimes& f) {
      return technique_ms(f.together, candidates.front().technique);
    };
    summary.technique_ratio = ratio(frames, rounds.front(), of_technique, of_first);
    summary.frame_ratio = ratio(frames, rounds.front(), frame_ms, frame_ms);
    summaries.push_back(std::move(summary));
  }
  return summaries;
}

std::string group_of(const std::string& pass) {
  return pass.substr(0, pass.find('@'));
}

std::vector<std::string> group_names(const FrameTimes& frame) {
  std::vector<std::string> names;
  for (const PassTime& pass : frame.passes) {
    const std::string name = group_of(pass.name);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

PassOwner owner_of(const std::string& pass, const ChosenTechnique& technique) {
  if (!technique.info) return PassOwner::host;
  if (pass.starts_with(technique.name() + ".") || pass.starts_with("voxels."))
    return PassOwner::technique;
  return pass.starts_with("renderer.view.") ? PassOwner::host_for_technique : PassOwner::host;
}

double technique_ms(const std::vector<PassTime>& passes, const ChosenTechnique& technique) {
  return ms_of(passes, technique, PassOwner::technique);
}

double host_ms(const std::vector<PassTime>& passes, const ChosenTechnique& technique) {
  return ms_of(passes, technique, PassOwner::host_for_technique);
}

double group_ms(const FrameTimes& frame, const std::string& group) {
  double ms = 0;
  for (const PassTime& pass : frame.passes)
    if (group_of(pass.name) == group) ms += pass.gpu_ms;
  return ms;
}

}  // namespace lueur::cli
