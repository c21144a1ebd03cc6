// SPDX-License-Identifier: MIT
#include "sequence.h"

#include <gtest/gtest.h>

namespace lueur::cli {
namespace {

const Sequence kSequence{.setup = {{64, 36}, 7}, .pace = {.from_s = 2.0f, .rate = 50.0f}};

// The means of renderings need different seeds, whatever the moving frames have.
TEST(SequenceShot, StandingSeedsDiffer) {
  Sequence sequence = kSequence;
  sequence.pace.fixed_seed = true;
  EXPECT_NE(standing_shot(sequence, {}, 3, 0).seed, standing_shot(sequence, {}, 3, 1).seed);
}

TEST(SequenceShot, StandsAtTheFrameWithTheSameSeeds) {
  const Shot shot = standing_shot(kSequence, {}, 3, 4);
  EXPECT_EQ(shot.time_s, time_of(kSequence.pace, 3));
  EXPECT_EQ(shot.previous_time_s, shot.time_s);
  EXPECT_EQ(shot.seed, standing_shot(kSequence, {}, 9, 4).seed);
}

TEST(SequenceFile, StemIsSafe) {
  EXPECT_EQ(file_stem("none"), "none");
  EXPECT_EQ(file_stem("hierarchical:samples=32:radius=1.5"), "hierarchical_samples=32_radius=1.5");
  EXPECT_EQ(file_stem("../a b\n/\xc3\xa9"), ".._a_b____");
}

}  // namespace
}  // namespace lueur::cli
