// SPDX-License-Identifier: MIT
#include "image/sequence_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace lueur {
namespace {

constexpr uint32_t kWidth = 40;
constexpr uint32_t kHeight = 6;

using OfPixel = std::function<float(int x, int y)>;

ImageF grey(const OfPixel& value) {
  ImageF image(kWidth, kHeight, 1);
  for (uint32_t y = 0; y < kHeight; ++y)
    for (uint32_t x = 0; x < kWidth; ++x)
      image.at(x, y, 0) = value(static_cast<int>(x), static_cast<int>(y));
  return image;
}

// Surfaces that face the camera, at a depth and with a motion in pixels along x.
Surfaces surfaces(const OfPixel& depth_m, const OfPixel& motion_px) {
  Surfaces result{ImageF(kWidth, kHeight, 2), grey(depth_m), ImageF(kWidth, kHeight, 3)};
  for (uint32_t y = 0; y < kHeight; ++y)
    for (uint32_t x = 0; x < kWidth; ++x) {
      result.motion.at(x, y, 0) =
          motion_px(static_cast<int>(x), static_cast<int>(y)) / static_cast<float>(kWidth);
      result.normal.at(x, y, 2) = 1.0f;
    }
  return result;
}

OfPixel always(float value) {
  return [value](int, int) { return value; };
}

float pattern(int x, int y) {
  return 1.0f + 0.5f * std::sin(0.9f * static_cast<float>(x) + 2.0f * static_cast<float>(y));
}

// An object 6 pixels wide, 1 m away, that moves 2 pixels a frame to the right before a wall at 3 m.
bool is_object(int x, int frame) {
  return x >= 2 * frame && x < 2 * frame + 6;
}
Surfaces object_before_wall(int frame) {
  return surfaces([=](int x, int) { return is_object(x, frame) ? 1.0f : 3.0f; },
                  [=](int x, int) { return is_object(x, frame) ? 2.0f : 0.0f; });
}

TEST(Flicker, TranslatedPatternHasNone) {
  const auto picture = [](int frame) {
    return grey([=](int x, int y) { return pattern(x - 3 * frame, y); });
  };
  const Surfaces plane = surfaces(always(2.0f), always(3.0f));
  FrameChange sum;
  for (int frame = 1; frame <= 4; ++frame) {
    const auto change = frame_change(picture(frame - 1), plane, picture(frame), plane);
    ASSERT_TRUE(change.ok()) << change.error().message;
    sum += *change;
  }
  EXPECT_EQ(sum.points, 4u * (kWidth - 3) * kHeight);  // 3 columns a frame come in from outside
  EXPECT_EQ(sum.flicker(), 0.0);
  // Followed with the wrong motion, the same sequence flickers.
  const Surfaces still = surfaces(always(2.0f), always(0.0f));
  EXPECT_GT(frame_change(picture(0), still, picture(1), still)->flicker(), 0.1);
}

// Bilinear interpolation is exact on a ramp. Bound: of single precision.
TEST(Flicker, HalfPixelsAreInterpolated) {
  const auto ramp = [](float shift_px) {
    return grey([=](int x, int) { return 1.0f + 0.1f * (static_cast<float>(x) - shift_px); });
  };
  const Surfaces plane = surfaces(always(2.0f), always(0.5f));
  const auto change = frame_change(ramp(0.0f), plane, ramp(0.5f), plane);
  ASSERT_TRUE(change.ok());
  EXPECT_EQ(change->points, uint64_t{kWidth - 1} * kHeight);
  EXPECT_NEAR(change->flicker(), 0.0, 1e-6);
}

TEST(Flicker, OfKnownStrength) {
  const Surfaces plane = surfaces(always(2.0f), always(0.0f));
  const ImageF dim = grey(always(0.9f)), bright = grey(always(1.1f));
  FrameChange sum;
  sum += *frame_change(dim, plane, bright, plane);
  sum += *frame_change(bright, plane, dim, plane);
  EXPECT_NEAR(sum.flicker(), 0.2, 1e-6);  // 0.2 each time, of a mean of 1
  EXPECT_EQ(FrameChange().flicker(), 0.0);
}

TEST(Flicker, OnlyPointsOfTheSameSurfaceAreCompared) {
  // The object is lit, the wall is not so: whatever it covers or uncovers is no flicker.
  const auto picture = [](int frame) {
    return grey([=](int x, int) { return is_object(x, frame) ? 5.0f : 1.0f; });
  };
  const auto change =
      frame_change(picture(3), object_before_wall(3), picture(4), object_before_wall(4));
  ASSERT_TRUE(change.ok());
  EXPECT_EQ(change->flicker(), 0.0);
  EXPECT_EQ(change->points, uint64_t{kWidth - 2} * kHeight);  // all but what was uncovered

  // At one depth, normals tell surfaces apart.
  Surfaces before = surfaces(always(2.0f), always(0.0f));
  const Surfaces now = before;
  for (uint32_t y = 0; y < kHeight; ++y) {
    before.normal.at(7, y, 2) = 0.0f;
    before.normal.at(7, y, 0) = 1.0f;
  }
  EXPECT_EQ(frame_change(picture(0), before, picture(0), now)->points,
            uint64_t{kWidth - 1} * kHeight);
}

TEST(Flicker, EmptyPixelsAreLeftOut) {
  const OfPixel half = [](int x, int) { return x < 10 ? 2.0f : 0.0f; };
  const Surfaces plane = surfaces(half, always(0.0f));
  EXPECT_EQ(frame_change(grey(pattern), plane, grey(pattern), plane)->points, 10u * kHeight);
}

TEST(Ghosting, UncoveredPixelsAreKnownForTheirFrames) {
  UncoveredPixels uncovered;
  for (int frame = 0; frame <= 5; ++frame) {
    ASSERT_TRUE(uncovered.add(object_before_wall(frame)).ok());
    if (frame == 0) {
      EXPECT_EQ(uncovered.within(100).pixel_count(), 0u);
    }
  }
  // At frame 5 the object starts at x = 10; behind it lie 2 columns for each frame.
  for (const uint32_t frames : {1u, 3u}) {
    const Mask mask = uncovered.within(frames);
    for (uint32_t y = 0; y < kHeight; ++y)
      for (uint32_t x = 0; x < kWidth; ++x)
        EXPECT_EQ(mask.counts[y * kWidth + x], x >= 10 - 2 * frames && x < 10 ? 1 : 0) << x;
  }
  EXPECT_EQ(uncovered.within(0).pixel_count(), 0u);
  EXPECT_EQ(uncovered.within(100).pixel_count(), 10u * kHeight);
}

// The whole view moves on by 4 pixels a frame after the object has left: what it uncovered is
// followed.
TEST(Ghosting, UncoveredPixelsMoveWithTheirSurface) {
  UncoveredPixels uncovered;
  ASSERT_TRUE(uncovered.add(object_before_wall(3)).ok());
  ASSERT_TRUE(uncovered.add(object_before_wall(4)).ok());  // uncovers x = 6 and 7
  const Surfaces panned = surfaces([](int x, int) { return is_object(x - 4, 5) ? 1.0f : 3.0f; },
                                   [](int x, int) { return is_object(x - 4, 5) ? 6.0f : 4.0f; });
  ASSERT_TRUE(uncovered.add(panned).ok());
  const Mask fresh = uncovered.within(1), all = uncovered.within(2);
  for (uint32_t x = 0; x < kWidth; ++x) {
    EXPECT_EQ(fresh.counts[x], x == 12 || x == 13 ? 1 : 0) << x;
    EXPECT_EQ(all.counts[x], x >= 10 && x < 14 ? 1 : 0) << x;
  }
}

// A trail that starts at half the wall's light and halves with every frame.
TEST(Ghosting, OfADecayingTrail) {
  constexpr int kLast = 8;
  UncoveredPixels uncovered;
  for (int frame = 0; frame <= kLast; ++frame)
    ASSERT_TRUE(uncovered.add(object_before_wall(frame)).ok());
  const ImageF reference = grey(always(2.0f));
  const ImageF test = grey([](int x, int) {
    const int frames_ago = kLast - 1 - x / 2;  // since x was uncovered
    return 2.0f + (frames_ago >= 0 ? std::exp2(-static_cast<float>(frames_ago)) : 77.0f);
  });
  const auto trail = ghosting(test, reference, uncovered.within(3));
  ASSERT_TRUE(trail.ok()) << trail.error().message;
  EXPECT_EQ(trail->pixels, 6u * kHeight);
  EXPECT_NEAR(trail->bias(), 0.5 * (1.0 + 0.5 + 0.25) / 3.0, 1e-7);
  EXPECT_EQ(trail->error(), trail->bias());
  const auto dark = ghosting(reference, test, uncovered.within(1));
  EXPECT_NEAR(dark->bias(), -1.0 / 3.0, 1e-7);
  EXPECT_NEAR(dark->error(), 1.0 / 3.0, 1e-7);

  const auto none = ghosting(test, reference, uncovered.within(0));
  ASSERT_TRUE(none.ok());
  EXPECT_EQ(none->pixels, 0u);
  EXPECT_EQ(none->error(), 0.0);
}

// Bright and dark ghosts cancel in the bias, not in the error.
TEST(Ghosting, ErrorDoesNotCancel) {
  const Mask mask{kWidth, kHeight, std::vector<uint8_t>(size_t{kWidth} * kHeight, 1)};
  const ImageF test = grey([](int x, int) { return x % 2 == 0 ? 1.25f : 0.75f; });
  const auto result = ghosting(test, grey(always(1.0f)), mask);
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result->bias(), 0.0);
  EXPECT_EQ(result->error(), 0.25);
}

// Two frames' errors are those of their sums: a frame with more light weighs more.
TEST(Ghosting, FramesAddUp) {
  const Mask mask{kWidth, kHeight, std::vector<uint8_t>(size_t{kWidth} * kHeight, 1)};
  auto sum = ghosting(grey(always(2.0f)), grey(always(1.0f)), mask);
  const auto dark = ghosting(grey(always(2.0f)), grey(always(3.0f)), mask);
  ASSERT_TRUE(sum.ok() && dark.ok());
  *sum += *dark;
  EXPECT_EQ(sum->bias(), 0.0);   // (1 - 1) / (1 + 3)
  EXPECT_EQ(sum->error(), 0.5);  // (1 + 1) / (1 + 3)
  EXPECT_EQ(sum->pixels, 2u * kWidth * kHeight);
}

TEST(Sequence, WrongImagesAreRefused) {
  const Surfaces good = surfaces(always(2.0f), always(0.0f));
  Surfaces flat = good;
  flat.motion = ImageF(kWidth, kHeight, 3);
  ImageF broken = grey(pattern);
  broken.at(1, 2, 0) = std::numeric_limits<float>::quiet_NaN();
  const ImageF picture = grey(pattern);
  EXPECT_FALSE(frame_change(picture, flat, picture, good).ok());
  EXPECT_FALSE(frame_change(picture, good, picture, flat).ok());
  EXPECT_FALSE(frame_change(picture, good, broken, good).ok());
  EXPECT_FALSE(frame_change(ImageF(3, 3, 1), good, picture, good).ok());
  UncoveredPixels uncovered;
  EXPECT_NE(uncovered.add(flat).error().message.find("motion"), std::string::npos);
  ASSERT_TRUE(uncovered.add(good).ok());
  const Surfaces small{ImageF(2, 2, 2), ImageF(2, 2, 1), ImageF(2, 2, 3)};
  EXPECT_FALSE(uncovered.add(small).ok());
  EXPECT_FALSE(ghosting(picture, picture, Mask{1, 1, {1}}).ok());
}

// NaN in motion points nowhere; such pixels have no place in the frame before.
TEST(Sequence, BrokenMotionIsOutside) {
  const Surfaces good = surfaces(always(2.0f), always(0.0f));
  const Surfaces lost = surfaces(always(2.0f), always(std::numeric_limits<float>::quiet_NaN()));
  EXPECT_EQ(frame_change(grey(pattern), good, grey(pattern), lost)->points, 0u);
}

}  // namespace
}  // namespace lueur
