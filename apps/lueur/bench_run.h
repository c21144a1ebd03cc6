// SPDX-License-Identifier: MIT
// Times frames, and turns the times into numbers that can be compared.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "session.h"

namespace lueur::cli {

inline constexpr uint32_t kWarmUpFrames = 3;

// One scene under test. Does not move: the renderer refers to its scene's device copy only, but the
// technique keeps its history by the candidate.
struct Candidate {
  std::string scene_name;  // as given
  uint64_t triangles = 0;
  std::unique_ptr<Renderer> renderer;
  ChosenTechnique technique;
  Shot shot;
};

// What one frame took. `wall_ms` and `cpu_ms` are those of recording, submitting and waiting;
// `cpu_ms` counts all threads of the process, which on a CPU device are the ones that render.
struct FrameTimes {
  std::vector<PassTime> passes;
  double wall_ms = 0;
  double cpu_ms = 0;
};

Result<FrameTimes> time_frame(Session& session, Candidate& candidate);

struct PassSummary {
  std::string name;
  double gpu_ms = 0;  // median
  // Median of the frame's CPU time, shared out by GPU time: gpu_ms * cpu / wall. On a CPU device
  // this is the work of the pass; elsewhere it says little.
  double cpu_ms = 0;
  std::optional<uint64_t> samples;  // of passes that gather
};

struct BenchSummary {
  std::vector<PassSummary> passes;
  double technique_ms = 0;  // medians over the frames
  double frame_ms = 0;      // of all passes
  double wall_ms = 0;
  double cpu_ms = 0;
};

// Medians over `frames`, which has at least one.
BenchSummary summarize(const std::vector<FrameTimes>& frames, const Candidate& candidate);

// How many samples the pass "hierarchical.gather@K" takes: pixels of level K times samples a pixel.
// None for other passes, and where every pixel of the ring is a sample.
std::optional<uint64_t> samples_of(const std::string& pass, const ChosenTechnique& technique,
                                   Extent size);

}  // namespace lueur::cli
