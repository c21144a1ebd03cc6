// SPDX-License-Identifier: MIT
// Several bounces, on a scene whose every bounce is known: inside a sphere all points get the same
// light. A square view of 90 degrees from the centre sees a sixth of it, so of what it sees,
// radiance L gives each point L/6.
#include <cmath>
#include <numbers>

#include "techniques/hierarchical/hierarchical_fixture.h"

namespace lueur {
namespace {

constexpr double kShare = 1.0 / 6.0;
constexpr float kAlbedo = 0.9f;

class BouncesTest : public HierarchicalTest {
 protected:
  BouncesTest() {
    g_ = cast_g_buffer(white_sphere, {64, 64}, std::numbers::pi / 2, {0, 0, 0});
    g_.albedo.assign(g_.depth.size(), glm::vec3(kAlbedo));
    g_.motion.assign(g_.depth.size(), glm::vec2(0));
    settings_ = exhaustive();
    settings_.temporal = 0;
  }

  double mean_after(int frames) {
    Hierarchical technique(settings_);
    Light light;
    for (int i = 0; i < frames; ++i)
      light = next_frame(technique, g_, {.previous_view = g_.view, .cut = i == 0}).diffuse;
    double mean = 0;
    for (const glm::dvec3& l : light) mean += l.x / static_cast<double>(light.size());
    return mean;
  }

  CpuGBuffer g_;
  Settings settings_;
};

// E/pi = share + albedo share^2 + albedo^2 share^3 + ...
TEST_F(BouncesTest, EachBounceAddsItsTerm) {
  double sum = 0;
  for (int32_t n = 1; n <= 4; ++n) {
    sum += kShare * std::pow(double{kAlbedo} * kShare, n - 1);
    settings_.bounces = n;
    // A pixel is a flat patch: see FurnaceInsideASphere, 1 %.
    EXPECT_NEAR(mean_after(1) / sum, 1.0, 0.01) << n << " bounces";
  }
  settings_.bounces = 3;
  const double three = mean_after(1);
  settings_.bounces = 4;
  // The fourth is small; half floats near 0.19 lie a fifth of it apart.
  const double fourth = kShare * std::pow(double{kAlbedo} * kShare, 3);
  EXPECT_NEAR((mean_after(1) - three) / fourth, 1.0, 0.25);
}

// The second bounce comes a frame later, from the first one's picture, and both stay.
TEST_F(BouncesTest, InterleavedBouncesAddUpToTwo) {
  settings_.bounces = 2;
  const double both = mean_after(1);
  settings_.interleave = true;
  for (int frames = 2; frames <= 5; ++frames)
    EXPECT_NEAR(mean_after(frames) / both, 1.0, 2.0 / 1024) << frames << " frames";
}

// share / (1 - albedo share), the sum of all bounces.
TEST_F(BouncesTest, FeedbackConvergesToAllBounces) {
  settings_.feedback = true;
  const double all = kShare / (1 - double{kAlbedo} * kShare);
  EXPECT_NEAR(mean_after(1) / kShare, 1.0, 0.01);
  EXPECT_NEAR(mean_after(8) / all, 1.0, 0.01);
  // The filter only delays it.
  settings_.temporal = 0.8f;
  EXPECT_NEAR(mean_after(40) / all, 1.0, 0.01);
}

TEST_F(BouncesTest, TheSourceOfCoarseLevelsIsReflectedToo) {
  settings_ = {};
  settings_.radius = 4;
  settings_.levels = 5;
  settings_.temporal = 0;
  const double one = mean_after(1);
  settings_.bounces = 2;
  EXPECT_NEAR((mean_after(1) - one) / (double{kAlbedo} * one * one), 1.0, 0.03);
}

TEST_F(BouncesTest, WhatIsMissingIsSaid) {
  g_.albedo.clear();
  settings_.bounces = 2;
  const auto result = system().run([&](VkCommandBuffer commands) {
    Frame frame = context().record(commands);
    Hierarchical(settings_).render(frame, {.view = g_.view, .g_buffer = g_.upload(recorder())});
    return frame.finish();
  });
  ASSERT_FALSE(result.ok());
  EXPECT_NE(result.error().message.find("albedo"), std::string::npos);
}

}  // namespace
}  // namespace lueur
