// SPDX-License-Identifier: MIT
#include "timing.h"

#include <gtest/gtest.h>

namespace lueur::cli {
namespace {

// Timed together, the technique takes half of what its passes do one by one.
FrameTimes frame(double gather0_ms, double gather1_ms, double light_ms) {
  FrameTimes times;
  if (gather0_ms > 0.0) {
    times.passes = {{"hierarchical.gather@1", gather1_ms}, {"hierarchical.gather@0", gather0_ms}};
    times.together = {{"hierarchical.*", 0.5 * (gather0_ms + gather1_ms)}};
  }
  times.passes.push_back({"renderer.light", light_ms});
  times.together.push_back({"renderer.*", light_ms});
  times.wall_ms = 2.0 * (gather0_ms + gather1_ms + light_ms);
  times.cpu_ms = 3.0 * times.wall_ms;  // three threads
  return times;
}

Candidate candidate(const std::string& technique) {
  Candidate made;
  auto chosen = choose_technique(technique, {});
  made.technique = std::move(*chosen);
  made.shot.extent = {64, 36};
  return made;
}

const PassSummary* find(const std::vector<PassSummary>& rows, const std::string& name) {
  for (const PassSummary& row : rows)
    if (row.name == name) return &row;
  return nullptr;
}

TEST(Timing, PassesAndGroupsAreSummarised) {
  std::vector<Candidate> candidates;
  candidates.push_back(candidate("hierarchical"));
  const Rounds rounds = {{frame(4, 1, 10), frame(2, 5, 10), frame(3, 6, 20)}};
  const std::vector<Summary> all = summarize(rounds, candidates);
  ASSERT_EQ(all.size(), 1u);
  const Summary& summary = all.front();

  ASSERT_EQ(summary.passes.size(), 3u);
  const PassSummary* gather = find(summary.passes, "hierarchical.gather@0");
  ASSERT_NE(gather, nullptr);
  EXPECT_EQ(gather->gpu_ms.median, 3);
  EXPECT_EQ(gather->gpu_ms.least, 2);
  EXPECT_EQ(gather->gpu_ms.most, 4);
  EXPECT_EQ(gather->cpu_ms, 9);
  EXPECT_EQ(gather->samples, 32u * 18 * 64);  // half of the size, 64 samples by default
  EXPECT_FALSE(find(summary.passes, "renderer.light")->samples);

  // A group adds up frame by frame: 5, 7, 9. The sum of the medians would be 8.
  ASSERT_EQ(summary.groups.size(), 2u);
  EXPECT_EQ(find(summary.groups, "hierarchical.gather")->gpu_ms.median, 7);
  EXPECT_EQ(summary.technique_ms.median, 3.5);
  EXPECT_EQ(summary.technique_cpu_ms, 10.5);
  EXPECT_EQ(summary.frame_ms.median, 13.5);
  EXPECT_EQ(summary.frame_ms.most, 24.5);
  EXPECT_EQ(summary.wall_ms.median, 34);
  EXPECT_EQ(summary.cpu_ms.median, 102);
  EXPECT_EQ(summary.technique_ratio, 1.0);
  EXPECT_EQ(summary.frame_ratio, 1.0);
}

// What would not be there without the technique is told: its own work and its voxels as its time,
// other views as the host's for it.
TEST(Timing, VoxelsAreTheTechniquesAndOtherViewsTheHosts) {
  std::vector<Candidate> candidates;
  candidates.push_back(candidate("hierarchical"));
  candidates.push_back(candidate("none"));
  FrameTimes times = frame(4, 1, 10);
  times.together.push_back({"voxels.*", 16});
  times.together.push_back({"hierarchical.*", 32});
  times.together.push_back({"renderer.view.*", 64});
  times.together.push_back({"renderer.view.light.*", 128});
  times.together.push_back({"renderer.*", 256});
  const std::vector<Summary> all = summarize({{times}, {frame(0, 0, 5)}}, candidates);
  EXPECT_EQ(all[0].technique_ms.median, 2.5 + 16 + 32);
  EXPECT_EQ(all[0].host_ms.median, 64 + 128);
  EXPECT_EQ(all[0].frame_ms.median, 2.5 + 10 + 16 + 32 + 64 + 128 + 256);
  EXPECT_EQ(all[1].technique_ms.median, 0);
  EXPECT_EQ(all[1].host_ms.median, 0);
}

// The machine is ten times slower in the second round: in each round the second candidate takes
// half of the first one's time, which medians over all rounds would not tell.
TEST(Timing, RatiosAreOfTheSameRound) {
  std::vector<Candidate> candidates;
  for (int i = 0; i < 2; ++i) candidates.push_back(candidate("hierarchical"));
  const Rounds rounds = {{frame(2, 2, 12), frame(30, 10, 120), frame(6, 2, 12)},
                         {frame(1, 1, 6), frame(10, 10, 60), frame(2, 2, 6)}};
  const std::vector<Summary> all = summarize(rounds, candidates);
  EXPECT_EQ(all[0].technique_ratio, 1.0);
  EXPECT_EQ(all[1].technique_ratio, 0.5);
  EXPECT_EQ(all[1].frame_ratio, 0.5);
}

TEST(Timing, NothingHasNoRatioToNone) {
  std::vector<Candidate> candidates;
  candidates.push_back(candidate("none"));
  candidates.push_back(candidate("hierarchical"));
  const Rounds rounds = {{frame(0, 0, 5)}, {frame(3, 2, 5)}};
  const std::vector<Summary> all = summarize(rounds, candidates);
  EXPECT_EQ(all[0].technique_ms.median, 0);
  EXPECT_FALSE(all[0].technique_ratio);
  EXPECT_FALSE(all[1].technique_ratio);
  EXPECT_EQ(all[1].frame_ratio, 1.5);
  // The other way round, none takes none of the time.
  std::swap(candidates[0], candidates[1]);
  const Rounds turned = {rounds[1], rounds[0]};
  EXPECT_EQ(summarize(turned, candidates)[1].technique_ratio, 0.0);
}

TEST(Timing, GroupsEndAtTheLevel) {
  EXPECT_EQ(group_of("hierarchical.gather@12"), "hierarchical.gather");
  EXPECT_EQ(group_of("hierarchical.output"), "hierarchical.output");
}

}  // namespace
}  // namespace lueur::cli
