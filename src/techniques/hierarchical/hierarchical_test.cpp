// SPDX-License-Identifier: MIT
// The technique on the device, on G-buffers with a known answer.
#include <cmath>

#include "techniques/hierarchical/hierarchical_fixture.h"

namespace lueur {
namespace {

// HSSIL (4) with (2) summed over all pixels in double precision. Written from the paper, apart from
// the shaders: angles by their cosines, lengths by square roots, solid angle by the frustum.
std::vector<glm::dvec3> brute_force(const CpuGBuffer& g, double vertical_fov_rad) {
  const size_t count = g.depth.size();
  const double w = g.extent.width, h = g.extent.height;
  const double tan_v = std::tan(vertical_fov_rad / 2), tan_h = tan_v * w / h;
  const glm::dmat3 view_from_world(
      g.view.view_from_world[0], g.view.view_from_world[1], g.view.view_from_world[2],
      g.view.view_from_world[4], g.view.view_from_world[5], g.view.view_from_world[6],
      g.view.view_from_world[8], g.view.view_from_world[9], g.view.view_from_world[10]);
  std::vector<glm::dvec3> result(count, glm::dvec3(0));
  for (size_t x = 0; x < count; ++x) {
    if (g.depth[x] == 0) continue;
    const glm::dvec3 n = view_from_world * glm::dvec3(g.normal[x]);
    for (size_t i = 0; i < count; ++i) {
      if (i == x || g.depth[i] == 0) continue;
      const glm::dvec3& p = g.position_view[i];
      const glm::dvec3 n_i = view_from_world * glm::dvec3(g.normal[i]);
      const double z = -p.z;
      const double cos_alpha = z / glm::length(p);
      const double cos_beta = -glm::dot(n_i, p) / glm::length(p);
      const double ds =
          z * z * 4 * tan_h * tan_v / (w * h) * std::min(cos_alpha / cos_beta, 20.0);  // (2)
      const glm::dvec3 d = p - g.position_view[x];
      const double r = glm::length(d);
      const double cos_theta = std::max(glm::dot(n, d) / r, 0.0);
      const double cos_theta_i = std::max(-glm::dot(n_i, d) / r, 0.0);
      const double disc_r2 = cos_theta_i * ds / kPi;
      result[x] += glm::dvec3(g.source[i]) * (disc_r2 * cos_theta / (r * r + disc_r2));  // (4)
    }
  }
  return result;
}

TEST_F(HierarchicalTest, EveryPixelAsASampleEqualsTheBruteForceSum) {
  const double fov = 1.2;
  // A turned camera, so that a mistake in the normals' space shows.
  const double angle = 0.3;
  const glm::dmat3 turn(std::cos(angle), 0, -std::sin(angle), 0, 1, 0, std::sin(angle), 0,
                        std::cos(angle));
  const CpuGBuffer g = cast_g_buffer(corner_room, {64, 48}, fov, {0.5, 0.2, 0.5}, turn);
  const auto truth = brute_force(g, fov);
  const auto ours = diffuse(g, exhaustive());
  // Half floats hold source, foreshortening and result: 2^-11 each.
  EXPECT_LT(relative_rmse(ours, truth), 3.0 / 2048);
  double worst = 0, brightest = 0;
  for (const auto& t : truth) brightest = std::max(brightest, glm::length(t));
  for (size_t i = 0; i < truth.size(); ++i)
    worst = std::max(worst, glm::length(ours[i] - truth[i]) / brightest);
  EXPECT_LT(worst, 3.0 / 2048);
}

// Inside a sphere of radiance 1 every patch gives every other A / (4 pi R^2): all points get the
// share of the sphere that the camera sees. A square 90 degree view from the centre sees a sixth.
TEST_F(HierarchicalTest, FurnaceInsideASphere) {
  const CpuScene sphere = [](const glm::dvec3&, const glm::dvec3& d) -> std::optional<CpuHit> {
    const glm::dvec3 p = 2.0 * glm::normalize(d);
    return CpuHit{p, -glm::normalize(p), glm::dvec3(1.0)};
  };
  CpuGBuffer g = cast_g_buffer(sphere, {96, 96}, kPi / 2, {0, 0, 0});
  for (const auto& light : diffuse(g, exhaustive())) ASSERT_NEAR(light.x * 6, 1.0, 0.01);

  // The same through rings, filters and interpolation, on average.
  g = cast_g_buffer(sphere, {256, 256}, kPi / 2, {0, 0, 0});
  double mean = 0;
  const auto light = diffuse(g, {});
  for (const auto& l : light) mean += l.x / static_cast<double>(light.size());
  EXPECT_NEAR(mean * 6, 1.0, 0.03);
}

// A floor point below a wall of radiance 1: differential element to a perpendicular rectangle.
TEST_F(HierarchicalTest, WallOverFloorFollowsTheClosedForm) {
  constexpr double kHalfWidth = 1.5, kHeight = 1.2, kBack = -4.0;
  const CpuScene scene = [](const glm::dvec3& o, const glm::dvec3& d) -> std::optional<CpuHit> {
    const double t_wall = (kBack - o.z) / d.z, t_floor = -o.y / d.y;
    const glm::dvec3 wall = o + t_wall * d;
    if (wall.y >= 0 && wall.y <= kHeight && std::abs(wall.x) <= kHalfWidth)
      return CpuHit{wall, {0, 0, 1}, glm::dvec3(1.0)};
    if (t_floor > 0 && (o + t_floor * d).z > kBack) return CpuHit{o + t_floor * d, {0, 1, 0}, {}};
    return std::nullopt;
  };
  const CpuGBuffer g = cast_g_buffer(scene, {192, 128}, 1.0, {0, 0.9, 0});
  const auto light = diffuse(g, exhaustive());

  // Form factor from a floor point at distance c from the wall to the part of width a on one side:
  // 1/(2 pi) (atan(a/c) - c / sqrt(c^2 + b^2) atan(a / sqrt(c^2 + b^2))).
  const auto one_side = [](double a, double b, double c) {
    const double s = std::sqrt(c * c + b * b);
    return (std::atan(a / c) - c / s * std::atan(a / s)) / (2 * kPi);
  };
  int compared = 0;
  for (size_t i = 0; i < light.size(); ++i) {
    if (g.depth[i] == 0 || g.normal[i].y < 0.5f) continue;
    const glm::dvec3 p = g.position_view[i] + glm::dvec3(0, 0.9, 0);
    const double c = p.z - kBack;
    // Right at the wall a single pixel of it counts, and its size with it.
    if (c < 0.1 || std::abs(p.x) > 1.0) continue;
    const double exact =
        one_side(kHalfWidth - p.x, kHeight, c) + one_side(kHalfWidth + p.x, kHeight, c);
    ASSERT_NEAR(light[i].x / exact, 1.0, 0.02) << "at " << p.x << ", " << c << " m off the wall";
    ++compared;
  }
  EXPECT_GT(compared, 2000);
}

// FDP figure 6: the levels' own images add up to the whole.
TEST_F(HierarchicalTest, LevelsAddUp) {
  const CpuGBuffer g = cast_g_buffer(corner_room, {160, 120}, 1.2, {0.5, 0.2, 0.5});
  Settings s;
  s.radius = 10;
  const auto whole = diffuse(g, s);
  std::vector<glm::dvec3> sum(whole.size(), glm::dvec3(0));
  for (s.only_level = 1; s.only_level <= s.levels; ++s.only_level) {
    const auto part = diffuse(g, s);
    for (size_t i = 0; i < sum.size(); ++i) sum[i] += part[i];
  }
  EXPECT_LT(relative_rmse(sum, whole), 2.0 / 1024);
}

// Rings over levels against one level that takes every pixel. What is left is the seams, where a
// coarse ring begins a texel early or late, and the coarse levels' averaging: less the wider the
// rings are in pixels (2.1 % at 40 px, 3.8 % at 20 px).
TEST_F(HierarchicalTest, RingsFollowTheWholeSum) {
  const CpuGBuffer g = cast_g_buffer(corner_room, {192, 144}, 1.2, {0.5, 0.2, 0.5});
  const auto whole = diffuse(g, exhaustive());
  Settings s = exhaustive();
  s.radius = 80;
  s.levels = 3;
  EXPECT_LT(relative_rmse(diffuse(g, s), whole), 0.02);
}

TEST_F(HierarchicalTest, ErrorFallsFasterThanWithRandomSamples) {
  const CpuGBuffer g = cast_g_buffer(striped_sphere, {192, 144}, 1.2, {0, 0, 0});
  Settings s;
  s.start = Settings::Start::full;
  s.filter = false;
  s.levels = 1;
  s.sampling = Settings::Sampling::every_pixel;
  const auto all = diffuse(g, s);
  s.sampling = Settings::Sampling::sparse;
  s.samples = 4;
  const double few = relative_rmse(diffuse(g, s), all);
  s.samples = 256;
  // 64 times as many random samples have an eighth of the error.
  EXPECT_LT(relative_rmse(diffuse(g, s), all), few / 8);
}

// Nine interleaved patterns average to one of nine times as many samples; were they unrelated, the
// error would fall to a third.
TEST_F(HierarchicalTest, TheFilterTakesTheSamplesPatternAway) {
  const CpuGBuffer g = cast_g_buffer(striped_sphere, {192, 144}, 1.2, {0, 0, 0});
  Settings s;
  s.start = Settings::Start::full;
  s.levels = 1;
  s.samples = 16;
  s.sampling = Settings::Sampling::every_pixel;
  s.filter = false;
  const auto all = diffuse(g, s);
  s.sampling = Settings::Sampling::sparse;
  const double raw = relative_rmse(diffuse(g, s), all);
  s.filter = true;
  EXPECT_LT(relative_rmse(diffuse(g, s), all), raw / 3);
}

TEST_F(HierarchicalTest, AnySizeWorks) {
  for (const Extent extent : {Extent{1, 1}, Extent{2, 1}, Extent{37, 61}, Extent{1367, 769}}) {
    const CpuGBuffer g = cast_g_buffer(corner_room, extent, 1.2, {0.5, 0.2, 0.5});
    for (const Settings::Start start :
         {Settings::Start::full, Settings::Start::half, Settings::Start::quarter}) {
      Settings s;
      s.start = start;
      s.levels = 8;
      s.samples = 8;
      const auto light = diffuse(g, s);
      ASSERT_EQ(light.size(), size_t{extent.width} * extent.height);
      double sum = 0;
      for (const auto& l : light) sum += l.x;
      ASSERT_TRUE(std::isfinite(sum));
      if (extent.width > 16) {
        EXPECT_GT(sum / static_cast<double>(light.size()), 0.01);
      }
    }
  }
}

// A coarser start blurs where surfaces meet and agrees elsewhere: inside the sphere, everywhere.
TEST_F(HierarchicalTest, StartLevelsAgree) {
  const CpuGBuffer g = cast_g_buffer(striped_sphere, {200, 150}, 1.2, {0, 0, 0});
  Settings s = exhaustive();
  const auto full = diffuse(g, s);
  s.start = Settings::Start::half;
  EXPECT_LT(relative_rmse(diffuse(g, s), full), 0.01);
  s.start = Settings::Start::quarter;
  EXPECT_LT(relative_rmse(diffuse(g, s), full), 0.01);
}

// A half-pixel mistake between levels moves light by a pixel or makes it jagged by as much. What
// half start adds to the error must be far less than what moving the whole picture by a pixel does.
TEST_F(HierarchicalTest, CoarserStartsKeepLightInItsPlace) {
  constexpr int kWidth = 160, kHeight = 120, kMargin = 8;
  const CpuGBuffer g = cast_g_buffer(corner_room, {kWidth, kHeight}, 1.2, {0.5, 0.2, 0.5});
  Settings s = exhaustive();
  const auto full = diffuse(g, s);
  s.start = Settings::Start::half;
  const auto half = diffuse(g, s);

  // Only where nothing but one plane is near: at edges a coarser start blurs, as it should.
  const auto at = [&](int x, int y) { return size_t(y) * size_t(kWidth) + size_t(x); };
  const auto is_flat = [&](int x, int y) {
    for (int dy = -kMargin; dy <= kMargin; ++dy)
      for (int dx = -kMargin; dx <= kMargin; ++dx)
        if (glm::dot(g.normal[at(x, y)], g.normal[at(x + dx, y + dy)]) < 0.999f) return false;
    return true;
  };
  double coarse = 0, moved = 0;
  for (int y = kMargin; y < kHeight - kMargin; ++y) {
    for (int x = kMargin; x < kWidth - kMargin; ++x) {
      if (!is_flat(x, y)) continue;
      // Curvature apart: what is common to a pixel and its neighbours is no displacement.
      const auto roughness = [&](const std::vector<glm::dvec3>& light) {
        return light[at(x, y)] - 0.5 * (light[at(x - 1, y)] + light[at(x + 1, y)]);
      };
      const glm::dvec3 jag = roughness(half) - roughness(full);
      const glm::dvec3 step = 0.5 * (full[at(x + 1, y)] - full[at(x - 1, y)]);
      coarse += glm::dot(jag, jag);
      moved += glm::dot(step, step);
    }
  }
  EXPECT_GT(moved, 0);
  EXPECT_LT(std::sqrt(coarse / moved), 0.25);
}

TEST_F(HierarchicalTest, SameSeedSameBits) {
  const CpuGBuffer g = cast_g_buffer(corner_room, {101, 67}, 1.2, {0.5, 0.2, 0.5});
  const auto first = diffuse(g, {}, 7);
  EXPECT_EQ(first, diffuse(g, {}, 7));
  EXPECT_NE(first, diffuse(g, {}, 8));
}

TEST_F(HierarchicalTest, NothingVisibleGivesNothing) {
  const CpuGBuffer g = cast_g_buffer(
      [](const glm::dvec3&, const glm::dvec3&) { return std::nullopt; }, {40, 30}, 1.0, {0, 0, 0});
  for (const auto& l : diffuse(g, {})) ASSERT_EQ(l, glm::dvec3(0));
}

TEST_F(HierarchicalTest, SettingsOutOfRangeFailTheFrame) {
  const CpuGBuffer g = cast_g_buffer(corner_room, {16, 16}, 1.2, {0.5, 0.2, 0.5});
  const auto result = system().run([&](VkCommandBuffer commands) {
    Frame frame = context().record(commands);
    Settings s;
    s.levels = 99;
    Hierarchical(s).render(frame, {.view = g.view, .g_buffer = g.upload(frame.recorder())});
    return frame.finish();
  });
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().kind, ErrorKind::usage);
  EXPECT_NE(result.error().message.find("levels=99"), std::string::npos);
}

}  // namespace
}  // namespace lueur
