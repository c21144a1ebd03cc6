// SPDX-License-Identifier: MIT
// Times candidates in turn, and turns the times into numbers that can be compared.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "candidate.h"
#include "statistics.h"

namespace lueur::cli {

// Frames before those that count: no more than count, as then nobody asks for accuracy.
constexpr uint32_t warm_up_frames(uint32_t rounds) {
  return rounds < 3 ? rounds : 3;
}

// What a candidate's turn took, two frames: the first with a timer for each pass, the second with
// one for all that an owner's passes take together. A timer costs time of its own, on a CPU device
// as much as a small pass, so that `passes` add up to more than `together`, which is what a frame
// takes. `wall_ms` and `cpu_ms` are of recording, submitting and waiting for the second; `cpu_ms`
// counts all threads of the process, which on a CPU device are the ones that render.
struct FrameTimes {
  std::vector<PassTime> passes;
  std::vector<PassTime> together;  // "hierarchical.*", see Timers
  double wall_ms = 0;
  double cpu_ms = 0;
};

// By candidate, then by round.
using Rounds = std::vector<std::vector<FrameTimes>>;

// Renders A A B B C C A A …, so that what slows the machine down for a while slows all of them:
// first warm_up_frames() rounds of one frame each that do not count, then `rounds`.
Result<Rounds> time_in_turn(Session& session, std::span<Candidate> candidates, uint32_t rounds);

// Of one pass, or of a group of passes: "hierarchical.gather" is all "hierarchical.gather@K".
struct PassSummary {
  std::string name;
  Distribution gpu_ms;
  // Median of the frame's CPU time, shared out by GPU time: gpu_ms * cpu / wall. On a CPU device
  // this is the work of the pass; elsewhere it says little.
  double cpu_ms = 0;
  std::optional<uint64_t> samples;  // of passes that gather, see samples_of()
};

struct Summary {
  std::vector<PassSummary> passes;
  std::vector<PassSummary> groups;
  Distribution technique_ms;    // of the technique's passes together
  double technique_cpu_ms = 0;  // as in PassSummary
  Distribution host_ms;         // of what the host renders for the technique alone
  Distribution frame_ms;        // of all passes
  Distribution wall_ms;
  Distribution cpu_ms;
  // Medians over the rounds of this candidate's time over the first one's in the same round; none
  // where that one takes no time.
  std::optional<double> technique_ratio;
  std::optional<double> frame_ratio;
};

// One for each candidate. Each has the same number of rounds, at least one.
std::vector<Summary> summarize(const Rounds& rounds, std::span<const Candidate> candidates);

// What "group@K" belongs to.
std::string group_of(const std::string& pass);
// The groups of a frame, each once, in the order of the passes.
std::vector<std::string> group_names(const FrameTimes& frame);

// Who a pass is for: without the technique, the technique's and the host's for it would not be
// there.
enum class PassOwner : uint8_t { technique, host_for_technique, host };

// A technique has its own passes, "NAME.*", and those of the voxels that it has made, "voxels.*".
// What the host renders because the technique asks for it are other views, "renderer.view.*".
PassOwner owner_of(const std::string& pass, const ChosenTechnique& technique);

// GPU time of the passes of that owner, and of a group of passes.
double technique_ms(const std::vector<PassTime>& passes, const ChosenTechnique& technique);
double host_ms(const std::vector<PassTime>& passes, const ChosenTechnique& technique);
double group_ms(const FrameTimes& frame, const std::string& group);

}  // namespace lueur::cli
