// SPDX-License-Identifier: MIT
// The technique against closed forms, and against its own samples summed in double precision.
#include "lueur/visibility_bitmask.h"

#include <algorithm>
#include <cmath>

#include "frame/screen_of_view.h"
#include "support/gpu_test.h"
#include "techniques/baselines/slice.h"

namespace lueur {
namespace {

using Settings = VisibilityBitmaskSettings;

// Where a ray meets a rectangle around `middle`, whose half sides are `u` and `v`, from its front.
std::optional<CpuHit> rectangle(const glm::dvec3& o, const glm::dvec3& d, const glm::dvec3& middle,
                                const glm::dvec3& u, const glm::dvec3& v, double radiance) {
  const glm::dvec3 n = glm::normalize(glm::cross(u, v));
  const double t = glm::dot(n, middle - o) / glm::dot(n, d);
  const glm::dvec3 off = o + t * d - middle;
  if (glm::dot(n, d) >= 0 || t <= 0 || std::abs(glm::dot(off, u)) > glm::dot(u, u) ||
      std::abs(glm::dot(off, v)) > glm::dot(v, v))
    return std::nullopt;
  return CpuHit{o + t * d, n, glm::dvec3(radiance)};
}

std::optional<CpuHit> nearer(const glm::dvec3& o, std::optional<CpuHit> a,
                             std::optional<CpuHit> b) {
  if (!a || !b) return a ? a : b;
  return glm::length(a->position - o) < glm::length(b->position - o) ? a : b;
}

std::optional<CpuHit> floor_only(const glm::dvec3& o, const glm::dvec3& d) {
  return rectangle(o, d, {0, -1, 0}, {0, 0, 1e4}, {1e4, 0, 0}, 1);
}

// A black floor, and a wall of radiance 1 at its end: 4 m wide, 2.5 m high.
constexpr double kWallZ = -5, kHalfWidth = 2, kHeight = 2.5;
std::optional<CpuHit> wall_and_floor(const glm::dvec3& o, const glm::dvec3& d) {
  return nearer(
      o, rectangle(o, d, {0, -1, 0}, {0, 0, -kWallZ}, {1e4, 0, 0}, 0),
      rectangle(o, d, {0, -1 + kHeight / 2, kWallZ}, {kHalfWidth, 0, 0}, {0, kHeight / 2, 0}, 1));
}

// The wall's cosine-weighted share of the hemisphere over a point of the floor: two rectangles at a
// right angle to it, each with a corner below the point's foot.
double form_factor_of_wall(const glm::dvec3& floor_point) {
  const double away = floor_point.z - kWallZ, top = std::hypot(away, kHeight);
  double sum = 0;
  for (const double width : {kHalfWidth - floor_point.x, kHalfWidth + floor_point.x})
    sum += (std::atan(width / away) - away / top * std::atan(width / top)) / (2 * kPi);
  return sum;
}

// A floor, a wall and a ball before it, each with its radiance.
std::optional<CpuHit> ball(const glm::dvec3& o, const glm::dvec3& d) {
  const glm::dvec3 centre(0.3, -0.3, -3.2);
  const double radius = 0.5, b = glm::dot(d, o - centre), a = glm::dot(d, d);
  const double root = b * b - a * (glm::dot(o - centre, o - centre) - radius * radius);
  std::optional<CpuHit> hit;
  if (root > 0) {
    const glm::dvec3 p = o + (-b - std::sqrt(root)) / a * d;
    hit = CpuHit{p, (p - centre) / radius, glm::dvec3(2.0)};
  }
  return nearer(o, hit,
                nearer(o, rectangle(o, d, {0, -1, 0}, {0, 0, -kWallZ}, {1e4, 0, 0}, 0.25),
                       rectangle(o, d, {0, 0, kWallZ}, {1e4, 0, 0}, {0, 1e4, 0}, 1)));
}

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
  static glm::dvec3 world_position(const CpuGBuffer& g, size_t i) {
    return glm::dvec3(world_from_view(g.view) * glm::dvec4(g.position_view[i], 1));
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
  const CpuGBuffer g = cast_g_buffer(wall_and_floor, {160, 160}, 1.2, {0, 0.5, 0});
  const Result r = render(g, {.slices = 48,
                              .samples = 160,
                              .radius_m = 100,
                              .distance_m = 100,
                              .thickness_m = 100,
                              .filter = false});
  double error = 0, sum = 0;
  size_t count = 0;
  for (size_t i = 0; i < r.open.size(); ++i) {
    const glm::dvec3 p = g.depth[i] == 0 ? glm::dvec3(0) : world_position(g, i);
    // Right at the wall's edges their half pixel counts for more.
    if (std::abs(p.y + 1) > 1e-3 || std::abs(p.x) > 1.5 || p.z < kWallZ + 0.15) continue;
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
  const CpuGBuffer g = cast_g_buffer(white, {67, 41}, 1.2, {0, 0.5, 0});
  const Result r = render(g, {.radius_m = 100, .distance_m = 100, .thickness_m = 0.2f});
  double darkest = 1;
  for (size_t i = 0; i < r.open.size(); ++i) {
    ASSERT_NEAR(r.diffuse[i], 1 - r.open[i], 1e-3) << i;
    darkest = std::min(darkest, r.open[i]);
  }
  EXPECT_LT(darkest, 0.7);
}

// Occlusion stops at its distance, light does not.
TEST_F(VisibilityBitmaskTest, WhatIsFartherDoesNotOcclude) {
  const CpuGBuffer g = cast_g_buffer(wall_and_floor, {67, 41}, 1.2, {0, 0.5, 0});
  const Result r = render(g, {.radius_m = 100, .distance_m = 0.5f, .thickness_m = 10});
  double far = 0, near = 1;
  for (size_t i = 0; i < r.open.size(); ++i) {
    if (g.depth[i] == 0) continue;
    const glm::dvec3 p = world_position(g, i);
    if (std::abs(p.y + 1) > 1e-3 || std::abs(p.x) > 1.8) continue;
    if (p.z > kWallZ + 0.7) {
      ASSERT_NEAR(r.open[i], 1, 1e-3) << p.z;
      far = std::max(far, r.diffuse[i]);
    } else if (p.z < kWallZ + 0.2) {
      near = std::min(near, r.open[i]);
    }
  }
  EXPECT_GT(far, 0.15);
  EXPECT_LT(near, 0.8);
}

TEST_F(VisibilityBitmaskTest, NothingIsOpenAndDark) {
  const CpuGBuffer g = cast_g_buffer(wall_and_floor, {16, 16}, 1.2, {0, 0.5, 0});
  const Result r = render(g, {});
  ASSERT_EQ(g.depth[8], 0.0f);
  EXPECT_EQ(r.open[8], 1);
  EXPECT_EQ(r.diffuse[8], 0);
}

TEST_F(VisibilityBitmaskTest, SamplesChangeWithTheSeed) {
  const CpuGBuffer g = cast_g_buffer(ball, {31, 17}, 0.9, {0, 0.2, 0});
  EXPECT_EQ(render(g, {}, 1).diffuse, render(g, {}, 1).diffuse);
  EXPECT_NE(render(g, {}, 1).diffuse, render(g, {}, 2).diffuse);
}

// --- the same samples in double precision, with angles in small steps instead of sectors ---

// Of one pixel: how much light arrives and how much stays open.
glm::dvec2 exact(const CpuGBuffer& g, size_t pixel, const Settings& s) {
  constexpr int kSteps = 2000;
  const Screen screen = screen_of_view(g.view, g.extent);
  const glm::dmat3 view_from_world = glm::transpose(glm::dmat3(world_from_view(g.view)));
  const auto normal = [&](size_t i) { return view_from_world * glm::dvec3(g.normal[i]); };
  const uvec2 at(pixel % g.extent.width, pixel / g.extent.width);
  const vec2 at_px = vec2(at) + 0.5f, extent(g.extent.width, g.extent.height);
  const glm::dvec3 p = g.position_view[pixel];
  const glm::dvec3 to_eye = -glm::normalize(p);
  glm::dvec2 sum(0);
  double weights = 0;
  for (uint k = 0; k < static_cast<uint>(s.slices); ++k) {
    const vec2 start = slice_start(at, 0, k);
    const vec2 direction = slice_direction(k, static_cast<uint>(s.slices), start.y);
    const vec2 line = direction * screen.ray_scale;
    const glm::dvec3 step(line, 0);
    const glm::dvec3 along = glm::normalize(step - to_eye * glm::dot(step, to_eye));
    const auto angle = [&](const glm::dvec3& to) {
      return std::atan2(glm::dot(to, along), glm::dot(to, to_eye));
    };
    const auto weight_at = [&](double h) {
      const glm::dvec3 to = std::cos(h) * to_eye + std::sin(h) * along;
      return std::abs(std::sin(h)) * std::max(glm::dot(to, normal(pixel)), 0.0);
    };
    std::array<bool, kSteps> covered{}, near{};
    const auto angle_of = [](int i) { return 2 * kPi * (i + 0.5) / kSteps - kPi; };
    double light = 0;
    for (const float side : {1.0f, -1.0f}) {
      const vec2 to_side = side * direction;
      const float reach =
          reach_px(at_px, to_side, extent, s.radius_m, static_cast<float>(-p.z), line);
      for (uint i = 0; i < static_cast<uint>(s.samples); ++i) {
        const vec2 there =
            at_px + to_side * sample_offset_px(i, static_cast<uint>(s.samples), start.x, reach);
        if (there.x < 0 || there.y < 0 || there.x >= extent.x || there.y >= extent.y) continue;
        const size_t q =
            static_cast<size_t>(there.y) * g.extent.width + static_cast<size_t>(there.x);
        if (g.depth[q] == 0) continue;
        const glm::dvec3 n = normal(q);
        const glm::dvec3 ray(glm::dvec2(ray_through(screen, there)), -1);
        glm::dvec3 front = -g.position_view[q].z * ray;
        // Where the line meets the pixel's plane, within half and double its distance.
        if (glm::dot(n, ray) < 0)
          front = ray * std::clamp(glm::dot(n, g.position_view[q]) / glm::dot(n, ray),
                                   -0.5 * g.position_view[q].z, -2 * g.position_view[q].z);
        const double r = glm::length(front - p);
        if (r > double{s.radius_m}) continue;
        const double a = angle(front - p);
        const double b = angle(front + double{s.thickness_m} * glm::normalize(front) - p);
        const bool faces = glm::dot(n, front - p) < -1e-4 * r;
        for (int h = 0; h < kSteps; ++h) {
          if (angle_of(h) < std::min(a, b) || angle_of(h) > std::max(a, b)) continue;
          if (!covered[h] && faces) light += double{g.source[q].x} * weight_at(angle_of(h));
          covered[h] = true;
          near[h] = near[h] || r <= double{s.distance_m};
        }
      }
    }
    // By how much the slice turns around the ray where it turns a little on the screen.
    const glm::dvec3 turned(glm::dvec2(-direction.y, direction.x) * glm::dvec2(screen.ray_scale),
                            0);
    const double turn = glm::dot(glm::cross(to_eye, along), turned) /
                        glm::length(step - to_eye * glm::dot(step, to_eye));
    double open = 0, whole = 0;
    for (int h = 0; h < kSteps; ++h) {
      whole += weight_at(angle_of(h));
      open += near[h] ? 0 : weight_at(angle_of(h));
    }
    sum += std::abs(turn) * glm::dvec2(light, open);
    weights += std::abs(turn) * whole;
  }
  return sum / weights;
}

TEST_F(VisibilityBitmaskTest, IsTheSumOverItsSamples) {
  const CpuGBuffer g = cast_g_buffer(ball, {48, 32}, 0.9, {0.2, 0.2, 0});
  for (const float thickness_m : {0.05f, 0.3f, 50.0f}) {
    const Settings settings{.slices = 6,
                            .samples = 12,
                            .radius_m = 6,
                            .distance_m = 0.8f,
                            .thickness_m = thickness_m,
                            .filter = false};
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

}  // namespace
}  // namespace lueur
