// SPDX-License-Identifier: MIT
// The technique against closed forms, and against its own samples summed in double precision.
#include "lueur/visibility_bitmask.h"

#include <algorithm>
#include <cmath>

#include "support/gpu_test.h"
#include "techniques/baselines/slice_scenes.h"

namespace lueur {
namespace {

using Settings = VisibilityBitmaskSettings;

class VisibilityBitmaskTest : public GpuTest {
 protected:
  struct Result {
    std::vector<double> diffuse;  // red
    std::vector<double> open;
  };
  Result render(const CpuGBuffer& g, const Settings& settings, uint32_t seed = 0) {
    VisibilityBitmask technique(settings);
    run([&](Frame& frame) {
      const Outputs out =
          technique.render(frame, {.view = g.view, .g_buffer = g.upload(recorder()), .seed = seed});
      EXPECT_EQ(out.occlusion.format, Format::r16f);
      EXPECT_FALSE(out.specular.valid());
      recorder().read_back("diffuse", out.diffuse);
      recorder().read_back("occlusion", out.occlusion);
    });
    Result result;
    const Pixels diffuse = pixels("diffuse"), occlusion = pixels("occlusion");
    for (size_t i = 0; i < occlusion.samples.size(); ++i) {
      result.diffuse.push_back(diffuse.samples[4 * i]);
      result.open.push_back(occlusion.samples[i]);
    }
    return result;
  }
};

// Whatever is in a plane covers nothing of its hemisphere, neither with its front nor its back.
TEST_F(VisibilityBitmaskTest, AFloorIsOpen) {
  const CpuGBuffer g = cast_g_buffer(floor_only, {67, 41}, 0.9, {0, 0.5, 0});
  for (const float thickness_m : {0.0f, 0.3f, 1000.0f}) {
    const Result r = render(g, {.thickness_m = thickness_m});
    for (size_t i = 0; i < r.open.size(); ++i) {
      ASSERT_NEAR(r.open[i], 1, 1e-3) << i;
      ASSERT_NEAR(r.diffuse[i], 0, 1e-3) << i;
    }
  }
}

// All of the wall is seen, and where it is not, it is open.
TEST_F(VisibilityBitmaskTest, AWallCoversItsFormFactor) {
  const CpuGBuffer g = see_wall({160, 160});
  const Result r = render(g, {.slices = 48,
                              .samples = 160,
                              .radius_m = 100,
                              .distance_m = 100,
                              .thickness_m = 100,
                              .filter = Settings::Filter::none});
  const auto places = floor_places(g);
  double error = 0, sum = 0;
  size_t count = 0;
  for (size_t i = 0; i < r.open.size(); ++i) {
    if (!places[i] || places[i]->z < kWallZ + 0.15) continue;
    const glm::dvec3 p = *places[i];
    const double want = form_factor_of_wall(p);
    // The wall's edges are known to half a pixel, 2 cm of its 2 to 4 m.
    ASSERT_NEAR(r.diffuse[i], want, 0.012) << p.x << ", " << p.z;
    ASSERT_NEAR(r.open[i], 1 - want, 0.012) << p.x << ", " << p.z;
    error += r.diffuse[i] - want;
    sum += want;
    ++count;
  }
  EXPECT_GT(count, 2000u);
  EXPECT_NEAR(error / sum, 0, 0.01);
}

// Light of 1 from all that is there, all of which faces the others: as much arrives as is covered,
// on the wall as on the floor.
TEST_F(VisibilityBitmaskTest, WhatIsCoveredShines) {
  const auto white = [](const glm::dvec3& o, const glm::dvec3& d) {
    auto hit = wall_and_floor(o, d);
    if (hit) hit->radiance = glm::dvec3(1);
    return hit;
  };
  const CpuGBuffer g = see_wall({67, 41}, white);
  const Result r = render(
      g,
      {.radius_m = 100, .distance_m = 100, .thickness_m = 0.2f, .filter = Settings::Filter::three});
  double darkest = 1;
  for (size_t i = 0; i < r.open.size(); ++i) {
    ASSERT_NEAR(r.diffuse[i], 1 - r.open[i], 1e-3) << i;
    darkest = std::min(darkest, r.open[i]);
  }
  EXPECT_LT(darkest, 0.7);
}

// Occlusion stops at its distance, light does not.
TEST_F(VisibilityBitmaskTest, WhatIsFartherDoesNotOcclude) {
  const CpuGBuffer g = see_wall({67, 41});
  const Result r = render(
      g,
      {.radius_m = 100, .distance_m = 0.5f, .thickness_m = 10, .filter = Settings::Filter::none});
  const auto places = floor_places(g);
  double far = 0, near = 1;
  for (size_t i = 0; i < r.open.size(); ++i) {
    if (!places[i]) continue;
    if (places[i]->z > kWallZ + 0.7) {
      ASSERT_NEAR(r.open[i], 1, 1e-3) << places[i]->z;
      far = std::max(far, r.diffuse[i]);
    } else if (places[i]->z < kWallZ + 0.2) {
      near = std::min(near, r.open[i]);
    }
  }
  EXPECT_GT(far, 0.15);
  EXPECT_LT(near, 0.8);
}

// Few samples, and a wall's light that is known: what the filters average comes closer to it.
TEST_F(VisibilityBitmaskTest, FiltersAverageSamplesThatInterleave) {
  const CpuGBuffer g = see_wall({120, 120});
  const auto places = floor_places(g);
  std::vector<double> errors;
  for (const Settings::Filter filter :
       {Settings::Filter::none, Settings::Filter::three, Settings::Filter::nine}) {
    const Result r =
        render(g, {.slices = 2, .radius_m = 100, .thickness_m = 100, .filter = filter});
    double bias = 0, squared = 0, count = 0;
    for (size_t i = 0; i < r.diffuse.size(); ++i) {
      if (!places[i] || places[i]->z < kWallZ + 1) continue;
      const double off = r.diffuse[i] - form_factor_of_wall(*places[i]);
      bias += off;
      squared += off * off;
      ++count;
    }
    // Without what few samples miss everywhere; what they miss more of here than there stays.
    errors.push_back(std::sqrt(squared / count - bias * bias / (count * count)));
  }
  EXPECT_LT(errors[1], 0.4 * errors[0]);
  EXPECT_LT(errors[2], 0.75 * errors[1]);
}

TEST_F(VisibilityBitmaskTest, NothingIsOpenAndDark) {
  const CpuGBuffer g = see_wall({16, 16});
  const Result r = render(g, {});
  ASSERT_EQ(g.depth[8], 0.0f);
  EXPECT_EQ(r.open[8], 1);
  EXPECT_EQ(r.diffuse[8], 0);
}

TEST_F(VisibilityBitmaskTest, SamplesChangeWithTheSeed) {
  const CpuGBuffer g = cast_g_buffer(balls, {31, 17}, 0.9, {0, 0.2, 0});
  EXPECT_EQ(render(g, {}, 1).diffuse, render(g, {}, 1).diffuse);
  EXPECT_NE(render(g, {}, 1).diffuse, render(g, {}, 2).diffuse);
}

// How much light arrives at one pixel and how much of it stays open, by the same samples with
// angles in small steps instead of sectors.
glm::dvec2 exact(const CpuGBuffer& g, size_t pixel, const Settings& s) {
  constexpr int kSteps = 2000;
  const auto angle_of = [](int i) { return 2 * kPi * (i + 0.5) / kSteps - kPi; };
  glm::dvec2 sum(0);
  double weights = 0;
  for (const ExactSlice& slice : exact_slices(g, pixel, {s.slices, s.samples, s.radius_m})) {
    std::array<bool, kSteps> covered{}, near{};
    for (const auto& [side, end] : {std::pair{&slice.positive, kPi}, {&slice.negative, -kPi}}) {
      glm::dvec3 last = g.position_view[pixel];
      double last_angle = end;
      for (const ExactSample& sample : *side) {
        const double r = glm::length(sample.to);
        const double front = slice.angle(sample.to);
        double a = front;
        double b = slice.angle(sample.to + double{s.thickness_m} * glm::normalize(sample.front));
        const bool is_one_surface =
            std::abs(glm::dot(sample.normal, sample.front - last)) < double{s.thickness_m};
        if (s.bridge && !sample.after_gap && is_one_surface) {
          a = std::min({front, b, last_angle});
          b = std::max({front, b, last_angle});
        }
        last = sample.front;
        last_angle = front;
        const bool faces = glm::dot(sample.normal, sample.to) < -1e-4 * r;
        for (size_t i = 0; i < kSteps; ++i) {
          const double h = angle_of(static_cast<int>(i));
          if (h < std::min(a, b) || h > std::max(a, b)) continue;
          if (!covered[i] && faces) sum.x += slice.turn * sample.radiance * slice.weight_at(h);
          covered[i] = true;
          near[i] = near[i] || r <= double{s.distance_m};
        }
      }
    }
    for (size_t i = 0; i < kSteps; ++i) {
      const double weight = slice.turn * slice.weight_at(angle_of(static_cast<int>(i)));
      weights += weight;
      sum.y += near[i] ? 0 : weight;
    }
  }
  return sum / weights;
}

TEST_F(VisibilityBitmaskTest, IsTheSumOverItsSamples) {
  const CpuGBuffer g = cast_g_buffer(balls, {48, 32}, 0.9, {0.2, 0.2, 0});
  struct Case {
    float radius_m, thickness_m;
    bool bridge;
  };
  // The last radius leaves the wall between the balls out, and no bridge leads across.
  for (const auto& [radius_m, thickness_m, bridge] : {Case{6, 0.05f, false},
                                                      {6, 0.3f, false},
                                                      {6, 50, false},
                                                      {6, 0.05f, true},
                                                      {6, 0.3f, true},
                                                      {1.2f, 1, true}}) {
    const Settings settings{.slices = 6,
                            .samples = 12,
                            .radius_m = radius_m,
                            .distance_m = 0.8f,
                            .thickness_m = thickness_m,
                            .bridge = bridge,
                            .filter = Settings::Filter::none};
    const Result r = render(g, settings);
    glm::dvec2 error(0), squared(0), mean(0);
    double count = 0;
    for (size_t i = 0; i < r.open.size(); i += 7) {
      const glm::dvec2 want = exact(g, i, settings);
      const glm::dvec2 off = glm::dvec2(r.diffuse[i], r.open[i]) - want;
      error += off;
      squared += off * off;
      mean += want;
      ++count;
    }
    // A sector is 1/32 of a slice, and its dither even: no bias, and for each edge of what is
    // covered a deviation of 1/32 / sqrt(6), over the root of six slices: 0.005.
    EXPECT_NEAR(error.x / count, 0, 0.001) << mean.x / count;
    EXPECT_NEAR(error.y / count, 0, 0.001) << mean.y / count;
    EXPECT_LT(std::sqrt(squared.x / count), 0.012);
    EXPECT_LT(std::sqrt(squared.y / count), 0.006);
    EXPECT_GT(mean.x / count, 0.01);
    EXPECT_LT(mean.y / count, 0.995);
  }
}

// Settings that code has filled in are held to their ranges.
TEST_F(VisibilityBitmaskTest, SettingsOutOfRangeFailTheFrame) {
  const CpuGBuffer g =
      cast_g_buffer([](const glm::dvec3&, const glm::dvec3&) { return std::optional<CpuHit>(); },
                    {8, 8}, 0.9, {0, 0, 0});
  const auto result = system().run([&](VkCommandBuffer commands) {
    Frame frame = context().record(commands);
    Settings settings;
    settings.slices = 0;
    VisibilityBitmask(settings).render(frame, {.view = g.view, .g_buffer = g.upload(recorder())});
    return frame.finish();
  });
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().kind, ErrorKind::usage);
  EXPECT_NE(result.error().message.find("slices"), std::string::npos) << result.error().message;
}

}  // namespace
}  // namespace lueur
