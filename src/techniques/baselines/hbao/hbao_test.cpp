// SPDX-License-Identifier: MIT
// The technique against closed forms, and against its own samples integrated in double precision.
#include "lueur/hbao.h"

#include <algorithm>
#include <cmath>

#include "support/gpu_test.h"
#include "techniques/baselines/slice_scenes.h"

namespace lueur {
namespace {

using Settings = HbaoSettings;

class HbaoTest : public GpuTest {
 protected:
  std::vector<double> open(const CpuGBuffer& g, const Settings& settings, uint32_t seed = 0) {
    Hbao technique(settings);
    run([&](Frame& frame) {
      const Outputs out =
          technique.render(frame, {.view = g.view, .g_buffer = g.upload(recorder()), .seed = seed});
      EXPECT_EQ(out.occlusion.format, Format::r16f);
      EXPECT_FALSE(out.diffuse.valid());
      EXPECT_FALSE(out.specular.valid());
      recorder().read_back("occlusion", out.occlusion);
    });
    const Pixels p = pixels("occlusion");
    return {p.samples.begin(), p.samples.end()};
  }
};

TEST_F(HbaoTest, AFloorIsOpen) {
  const CpuGBuffer g = cast_g_buffer(floor_only, {67, 41}, 0.9, {0, 0.5, 0});
  for (const float radius_m : {0.2f, 1000.0f})
    for (const double value : open(g, {.radius_m = radius_m})) ASSERT_NEAR(value, 1, 1e-3);
}

TEST_F(HbaoTest, AWallClosesItsFormFactor) {
  const CpuGBuffer g = see_wall({160, 160});
  const std::vector<double> found =
      open(g, {.slices = 48, .samples = 160, .radius_m = 100, .falloff = 0, .filter = false});
  const auto places = floor_places(g);
  double error = 0;
  size_t count = 0;
  for (size_t i = 0; i < found.size(); ++i) {
    if (!places[i] || places[i]->z < kWallZ + 0.15) continue;
    const double want = 1 - form_factor_of_wall(*places[i]);
    // The wall's edges are known to half a pixel, 2 cm of its 2 to 4 m.
    ASSERT_NEAR(found[i], want, 0.012) << places[i]->x << ", " << places[i]->z;
    error += found[i] - want;
    ++count;
  }
  EXPECT_GT(count, 2000u);
  EXPECT_NEAR(error / static_cast<double>(count), 0, 0.003);
}

TEST_F(HbaoTest, WhatIsFartherThanTheRadiusClosesNothing) {
  const CpuGBuffer g = see_wall({67, 41});
  const std::vector<double> found = open(g, {.radius_m = 0.5f, .falloff = 0.5f});
  const auto places = floor_places(g);
  double darkest = 1;
  for (size_t i = 0; i < found.size(); ++i) {
    if (places[i] && places[i]->z > kWallZ + 0.7) {
      ASSERT_NEAR(found[i], 1, 1e-3);
    }
    darkest = std::min(darkest, found[i]);
  }
  EXPECT_LT(darkest, 0.85);
}

TEST_F(HbaoTest, NothingIsOpenAndSamplesChangeWithTheSeed) {
  EXPECT_EQ(open(see_wall({16, 16}), {})[8], 1);
  const CpuGBuffer g = cast_g_buffer(balls, {31, 17}, 0.9, {0, 0.2, 0});
  EXPECT_EQ(open(g, {}, 1), open(g, {}, 1));
  EXPECT_NE(open(g, {}, 1), open(g, {}, 2));
}

// The share of a slice between two angles, by quadrature.
double share(const ExactSlice& slice, double from, double to) {
  constexpr int kSteps = 2000;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i)
    sum += slice.weight_at(from + (to - from) * (i + 0.5) / kSteps) * std::abs(to - from) / kSteps;
  return sum;
}

double exact(const CpuGBuffer& g, size_t pixel, const Settings& s) {
  double sum = 0, weights = 0;
  for (const ExactSlice& slice : exact_slices(g, pixel, {s.slices, s.samples, s.radius_m})) {
    const double whole = share(slice, -kPi, kPi);
    double closed = 0;
    for (const auto& [side, end] : {std::pair{&slice.positive, kPi}, {&slice.negative, -kPi}}) {
      double most = 0;
      for (const ExactSample& sample : *side) {
        const double near = 1 - glm::length(sample.to) / double{s.radius_m};
        most = std::max(most, share(slice, slice.angle(sample.to), end) *
                                  std::min(near / double{s.falloff}, 1.0));
      }
      closed += most;
    }
    sum += slice.turn * (whole - closed);
    weights += slice.turn * whole;
  }
  return sum / weights;
}

TEST_F(HbaoTest, IsTheIntegralAboveItsHorizons) {
  const CpuGBuffer g = cast_g_buffer(balls, {48, 32}, 0.9, {0.2, 0.2, 0});
  for (const float falloff : {1e-3f, 0.6f}) {
    const Settings settings{
        .slices = 5, .samples = 9, .radius_m = 2, .falloff = falloff, .filter = false};
    const std::vector<double> found = open(g, settings);
    double darkest = 1;
    for (size_t i = 0; i < found.size(); i += 7) {
      // Half floats, and quadrature in steps of 0.003 rad.
      ASSERT_NEAR(found[i], exact(g, i, settings), 2e-3) << i;
      darkest = std::min(darkest, found[i]);
    }
    EXPECT_LT(darkest, 0.8);
  }
}

// Settings that code has filled in are held to their ranges.
TEST_F(HbaoTest, SettingsOutOfRangeFailTheFrame) {
  const CpuGBuffer g =
      cast_g_buffer([](const glm::dvec3&, const glm::dvec3&) { return std::optional<CpuHit>(); },
                    {8, 8}, 0.9, {0, 0, 0});
  const auto result = system().run([&](VkCommandBuffer commands) {
    Frame frame = context().record(commands);
    Settings settings;
    settings.slices = 0;
    Hbao(settings).render(frame, {.view = g.view, .g_buffer = g.upload(recorder())});
    return frame.finish();
  });
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().kind, ErrorKind::usage);
  EXPECT_NE(result.error().message.find("slices"), std::string::npos) << result.error().message;
}

}  // namespace
}  // namespace lueur
