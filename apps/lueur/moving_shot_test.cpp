// SPDX-License-Identifier: MIT
#include "moving_shot.h"

#include <gtest/gtest.h>

namespace lueur::cli {
namespace {

const FrameSetup kSetup{{64, 36}, 7, {}};
constexpr Pace kPace{.from_s = 2.0f, .rate = 50.0f};

TEST(MovingShot, MovesByAFrame) {
  const Shot shot = moving_shot(kPace, kSetup, {1, {4, 2}}, 3);
  EXPECT_EQ(shot.camera, 1);
  EXPECT_EQ(shot.side_cameras, (std::vector<int32_t>{4, 2}));
  EXPECT_EQ(shot.extent, (Extent{64, 36}));
  EXPECT_FLOAT_EQ(shot.time_s, 2.06f);
  EXPECT_FLOAT_EQ(shot.previous_time_s, 2.04f);
  EXPECT_EQ(shot.seed, 10u);
  // Without a gap or a step twice: the time before is the one before's.
  EXPECT_EQ(shot.previous_time_s, moving_shot(kPace, kSetup, {1}, 2).time_s);
  EXPECT_EQ(moving_shot(kPace, kSetup, {1}, 0).previous_time_s,
            moving_shot(kPace, kSetup, {1}, -1).time_s);
}

TEST(MovingShot, SeedMayBeFixedAndGoesRound) {
  Pace pace = kPace;
  EXPECT_EQ(moving_shot(pace, kSetup, {}, -8).seed, UINT32_MAX);
  pace.fixed_seed = true;
  EXPECT_EQ(moving_shot(pace, kSetup, {}, -8).seed, 7u);
  EXPECT_EQ(moving_shot(pace, kSetup, {}, 3).seed, 7u);
}

}  // namespace
}  // namespace lueur::cli
