// SPDX-License-Identifier: MIT
#include "sequence.h"

#include <gtest/gtest.h>

namespace lueur::cli {
namespace {

const Sequence kSequence{.setup = {{64, 36}, 7}, .from_s = 2.0f, .rate = 50.0f};

TEST(SequenceShot, MovesByAFrame) {
  const Shot shot = moving_shot(kSequence, 1, 3);
  EXPECT_EQ(shot.camera, 1);
  EXPECT_EQ(shot.extent, (Extent{64, 36}));
  EXPECT_FLOAT_EQ(shot.time_s, 2.06f);
  EXPECT_FLOAT_EQ(shot.previous_time_s, 2.04f);
  EXPECT_EQ(shot.seed, 10u);
  // Without a gap or a step twice: the time before is the one before's.
  EXPECT_EQ(shot.previous_time_s, moving_shot(kSequence, 1, 2).time_s);
  EXPECT_EQ(moving_shot(kSequence, 1, 0).previous_time_s, moving_shot(kSequence, 1, -1).time_s);
}

TEST(SequenceShot, SeedMayBeFixedAndGoesRound) {
  Sequence sequence = kSequence;
  EXPECT_EQ(moving_shot(sequence, 0, -8).seed, UINT32_MAX);
  sequence.fixed_seed = true;
  EXPECT_EQ(moving_shot(sequence, 0, -8).seed, 7u);
  EXPECT_EQ(moving_shot(sequence, 0, 3).seed, 7u);
  // The mean needs different ones all the same.
  EXPECT_NE(standing_shot(sequence, 0, 3, 0).seed, standing_shot(sequence, 0, 3, 1).seed);
}

TEST(SequenceShot, StandsAtTheFrameWithTheSameSeeds) {
  const Shot shot = standing_shot(kSequence, 0, 3, 4);
  EXPECT_EQ(shot.time_s, moving_shot(kSequence, 0, 3).time_s);
  EXPECT_EQ(shot.previous_time_s, shot.time_s);
  EXPECT_EQ(shot.seed, standing_shot(kSequence, 0, 9, 4).seed);
}

TEST(SequenceFile, StemIsSafe) {
  EXPECT_EQ(file_stem("none"), "none");
  EXPECT_EQ(file_stem("hierarchical:samples=32:radius=1.5"), "hierarchical_samples=32_radius=1.5");
  EXPECT_EQ(file_stem("../a b\n/\xc3\xa9"), ".._a_b____");
}

}  // namespace
}  // namespace lueur::cli
