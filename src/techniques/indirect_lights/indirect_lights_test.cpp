// SPDX-License-Identifier: MIT
// The technique against closed forms and sums in double precision.
#include "lueur/indirect_lights.h"

#include <cmath>

#include "lights/light_rays.h"
#include "lights/light_views.h"
#include "support/gpu_test.h"

namespace lueur {
namespace {

using Settings = IndirectLightsSettings;
using Light = std::vector<glm::dvec3>;

constexpr uint32_t kViewPx = 128;

glm::dvec3 as_dvec3(const std::array<float, 3>& v) {
  return {v[0], v[1], v[2]};
}

// What a light gives to a surface, over pi. A spot shines as far as its view sees: its cone says
// where rays go, but the pixel they meet may have its middle outside.
glm::dvec3 arriving_over_pi(const PunctualLight& light, const CpuHit& hit) {
  const bool is_sun = light.kind == PunctualLight::Kind::directional;
  const glm::dvec3 to_light =
      is_sun ? -as_dvec3(light.direction) : as_dvec3(light.position) - hit.position;
  const double r = glm::length(to_light);
  const double cosine = std::max(glm::dot(hit.normal, to_light) / r, 0.0);
  return as_dvec3(light.intensity) * cosine / (kPi * (is_sun ? 1.0 : r * r));
}

// An engine with these surfaces, whose `radiance` is their albedo.
class LitHost final : public Host {
 public:
  LitHost(CpuScene scene, std::vector<PunctualLight> lights, Box bounds)
      : scene_(std::move(scene)), lights_(std::move(lights)), bounds_(bounds) {}
  GBuffer render_view(Frame& frame, const View& view, Extent extent,
                      const ViewContent& content) override {
    return seen(view, extent, lights_[static_cast<size_t>(content.light)]).upload(frame.recorder());
  }
  std::span<const PunctualLight> lights() const override { return lights_; }
  Box bounds() const override { return bounds_; }
  std::span<const TriangleBatch> triangles(Frame&) override { return {}; }

  const CpuScene& scene() const { return scene_; }
  CpuGBuffer seen(const View& view, Extent extent, const PunctualLight& light) const {
    return seen_through(
        [&](const glm::dvec3& o, const glm::dvec3& d) {
          auto hit = scene_(o, d);
          if (hit) hit->radiance *= arriving_over_pi(light, *hit);
          return hit;
        },
        view, extent);
  }

 private:
  CpuScene scene_;
  std::vector<PunctualLight> lights_;
  Box bounds_;
};

// A light as SOL 3.1 has it, in double precision.
struct ExactLight {
  glm::dvec3 position, normal, radiance;
  double area_m2;
};

std::vector<ExactLight> exact_lights(const LitHost& host, uint32_t count) {
  std::vector<ExactLight> exact;
  const std::vector<uint32_t> shares = shares_of_lights(host.lights(), host.bounds(), count);
  for (size_t i = 0; i < host.lights().size(); ++i) {
    const PunctualLight& light = host.lights()[i];
    const auto rays = rays_of_light(light, host.bounds(), shares[i]);
    std::vector<bool> taken(rays.size());
    for (const View& view : views_of_light(light, host.bounds())) {
      const glm::dmat4 to_world = world_from_view(view);
      const glm::dvec3 eye(to_world[3]);
      for (const auto& ray : rays_in_view(rays, view, kViewPx, taken)) {
        // Through the middle of the pixel.
        const glm::dvec2 clip =
            2.0 * (glm::floor(glm::dvec2(ray.at_px)) + 0.5) / double{kViewPx} - 1.0;
        const glm::dvec3 d(clip.x / view.clip_from_view[0], clip.y / view.clip_from_view[5], -1.0);
        const glm::dvec3 direction = glm::dmat3(to_world) * d;
        const auto hit = host.scene()(eye, direction);
        if (!hit) continue;
        const glm::dvec3 off = hit->position - eye;
        const double r = glm::length(off);
        const double cosine = -glm::dot(hit->normal, off) / r;
        exact.push_back({hit->position, hit->normal, hit->radiance * arriving_over_pi(light, *hit),
                         ray.solid_angle_sr * r * r / std::max(cosine, 1 / (20 * glm::length(d)))});
      }
    }
  }
  return exact;
}

// E/pi of SOL 3.2, with `scene` without what is hidden: I_s or I_c.
glm::dvec3 exact_sum(const std::vector<ExactLight>& lights, const glm::dvec3& position,
                     const glm::dvec3& normal, bool bound, const CpuScene* scene = nullptr) {
  glm::dvec3 sum(0);
  for (const ExactLight& l : lights) {
    const glm::dvec3 t = l.position - position;
    const double r2 = glm::dot(t, t);
    const double cosines = std::max(glm::dot(normal, t), 0.0) *
                           std::max(-glm::dot(l.normal, t), 0.0) * l.area_m2 / kPi;
    if (cosines == 0) continue;
    if (scene) {
      const auto hit = (*scene)(position + 1e-6 * normal, t);
      if (hit && glm::length(hit->position - position) < 0.999 * std::sqrt(r2)) continue;
    }
    sum += l.radiance * cosines / (r2 * (r2 + (bound ? l.area_m2 / kPi : 0.0)));
  }
  return sum;
}

// The inside of a sphere of radius 2, of albedo (0.5, 0.25, 1).
std::optional<CpuHit> sphere(const glm::dvec3& o, const glm::dvec3& d) {
  const double a = glm::dot(d, d), b = glm::dot(o, d), c = glm::dot(o, o) - 4.0;
  const double t = (-b + std::sqrt(b * b - a * c)) / a;
  const glm::dvec3 p = o + t * d;
  return CpuHit{p, -p / 2.0, {0.5, 0.25, 1.0}};
}

// A room of 6 x 4 x 6 m, open at the front, with a slab floating in it.
std::optional<CpuHit> room(const glm::dvec3& o, const glm::dvec3& d) {
  std::optional<CpuHit> best;
  double nearest = 1e30;
  const auto plane = [&](const glm::dvec3& n, double at, const glm::dvec3& albedo) {
    const double facing = glm::dot(n, d);
    if (facing >= 0) return;
    const double t = (at - glm::dot(n, o)) / facing;
    const glm::dvec3 p = o + t * d;
    if (t <= 1e-9 || t >= nearest || glm::any(glm::greaterThan(glm::abs(p), glm::dvec3(3.001))))
      return;
    nearest = t;
    best = CpuHit{p, n, albedo};
  };
  plane({0, 1, 0}, -2, {0.7, 0.7, 0.6});
  plane({0, -1, 0}, -2, {0.5, 0.5, 0.5});
  plane({0, 0, 1}, -3, {0.6, 0.6, 0.7});
  plane({1, 0, 0}, -3, {0.7, 0.2, 0.1});
  plane({-1, 0, 0}, -3, {0.1, 0.6, 0.2});
  const glm::dvec3 low(-1.0, -0.6, -2.0), high(1.0, -0.3, 0.5);
  double enter = 0, leave = 1e30;
  glm::dvec3 normal(0);
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (low[axis] - o[axis]) / d[axis], b = (high[axis] - o[axis]) / d[axis];
    if (std::min(a, b) > enter) {
      enter = std::min(a, b);
      normal = glm::dvec3(0);
      normal[axis] = d[axis] > 0 ? -1 : 1;
    }
    leave = std::min(leave, std::max(a, b));
  }
  if (enter < leave && enter > 1e-9 && enter < nearest)
    best = CpuHit{o + enter * d, normal, {0.4, 0.4, 0.4}};
  return best;
}
const Box kRoomBounds{{-3, -2, -3}, {3, 2, 3}};
// Shines on the floor beside and below the slab, and on the slab.
const PunctualLight kSpot{.kind = PunctualLight::Kind::spot,
                          .position = {0, 1.9f, 0},
                          .direction = {0, -1, 0},
                          .intensity = {30, 30, 30},
                          .outer_cone_rad = 0.8f};
const PunctualLight kBulb{.position = {-2, 1, 1}, .intensity = {4, 6, 8}};
const PunctualLight kSun{.kind = PunctualLight::Kind::directional,
                         .direction = {0.48f, -0.6f, -0.64f},
                         .intensity = {2, 2, 1}};

class IndirectLightsTest : public GpuTest {
 protected:
  IndirectLightsTest() {
    settings_.light_view_px = kViewPx;
    settings_.negative_lights = 0;
    settings_.low_resolution = Settings::LowResolution::none;
  }
  // E/pi; `gathered_` tells the pixels that were not interpolated.
  Light diffuse(const CpuGBuffer& g, LitHost& host, uint32_t seed = 0) {
    IndirectLights technique(settings_);
    run([&](Frame& frame) {
      const Outputs out = technique.render(
          frame, {.view = g.view, .g_buffer = g.upload(recorder()), .seed = seed, .host = &host});
      recorder().read_back("diffuse", out.diffuse);
    });
    const Pixels p = pixels("diffuse");
    Light light;
    gathered_.clear();
    for (size_t i = 0; i + 3 < p.samples.size(); i += 4) {
      light.emplace_back(p.samples[i], p.samples[i + 1], p.samples[i + 2]);
      EXPECT_TRUE(p.samples[i + 3] == 0 || p.samples[i + 3] == 1) << p.samples[i + 3];
      gathered_.push_back(p.samples[i + 3] == 1);
    }
    return light;
  }
  static glm::dvec3 world_position(const CpuGBuffer& g, size_t i) {
    return glm::dvec3(world_from_view(g.view) * glm::dvec4(g.position_view[i], 1));
  }

  Settings settings_;
  std::vector<bool> gathered_;
};

// In a sphere, what one point gives to another is the same wherever they are: the light's flux
// times albedo, spread over all of it.
TEST_F(IndirectLightsTest, ASphereSpreadsAllFluxEvenly) {
  settings_.bound = false;
  const CpuGBuffer g = cast_g_buffer(sphere, {33, 17}, 1.2, {0.3, 0.2, 0.4});
  PunctualLight narrow = kSpot, wide = kSpot;
  narrow.position = wide.position = {};
  wide.outer_cone_rad = 1.5f;
  PunctualLight bulb = kBulb;
  bulb.position = {};
  for (const PunctualLight& light : {narrow, wide, bulb}) {
    const double solid_angle = light.kind == PunctualLight::Kind::point
                                   ? 4 * kPi
                                   : 2 * kPi * (1 - std::cos(double{light.outer_cone_rad}));
    const glm::dvec3 flux = as_dvec3(light.intensity) * solid_angle;
    const glm::dvec3 want = flux * glm::dvec3(0.5, 0.25, 1.0) / (4 * kPi * 4.0) / kPi;
    LitHost host(sphere, {light}, {{-2, -2, -2}, {2, 2, 2}});
    for (const glm::dvec3& value : diffuse(g, host))
      for (int c = 0; c < 3; ++c) ASSERT_NEAR(value[c] / want[c], 1, 4e-3);
  }
}

TEST_F(IndirectLightsTest, IsTheSumOfItsLights) {
  LitHost host(room, {kSpot, kBulb, kSun}, kRoomBounds);
  for (const double eye_x : {0.0, 1.2}) {
    const CpuGBuffer g = cast_g_buffer(room, {67, 41}, 0.9, {eye_x, 0.1, 5.5});
    for (const bool bound : {true, false}) {
      settings_.bound = bound;
      const Light found = diffuse(g, host);
      const std::vector<ExactLight> lights = exact_lights(host, 300);
      for (size_t i = 0; i < found.size(); ++i) {
        if (g.depth[i] == 0) {
          ASSERT_EQ(found[i], glm::dvec3(0));
          continue;
        }
        const glm::dvec3 want =
            exact_sum(lights, world_position(g, i), glm::dvec3(g.normal[i]), bound);
        // Half floats, and the depth's rounding next to a light.
        for (int c = 0; c < 3; ++c) ASSERT_NEAR(found[i][c], want[c], 3e-3 * want[c] + 1e-5) << i;
      }
    }
  }
}

TEST_F(IndirectLightsTest, NegativeLightsBringWhatIsBlockedCloser) {
  LitHost host(room, {kSpot}, kRoomBounds);
  const CpuGBuffer g = cast_g_buffer(room, {96, 64}, 0.9, {0, 0.1, 5.5});
  const std::vector<ExactLight> lights = exact_lights(host, 300);
  double error[2] = {};
  for (const bool has_negative : {false, true}) {
    settings_.negative_lights = has_negative ? 300 : 0;
    const Light found = diffuse(g, host);
    for (size_t i = 0; i < found.size(); ++i) {
      if (g.depth[i] == 0) continue;
      const glm::dvec3 want =
          exact_sum(lights, world_position(g, i), glm::dvec3(g.normal[i]), true, &host.scene());
      error[has_negative] += glm::dot(found[i] - want, found[i] - want);
    }
  }
  EXPECT_LT(error[1], 0.8 * error[0]);
}

TEST_F(IndirectLightsTest, OnlyWhatIsNotAlikeIsGatheredTwice) {
  LitHost host(room, {kSpot}, kRoomBounds);
  settings_.negative_lights = 100;
  const CpuGBuffer g = cast_g_buffer(room, {131, 83}, 0.9, {0.3, 0.1, 5.5});
  const Light all = diffuse(g, host);
  LitHost dark(room, {}, kRoomBounds);
  double power = 0;
  for (const glm::dvec3& value : all) power += glm::dot(value, value);
  for (const auto low : {Settings::LowResolution::half, Settings::LowResolution::quarter}) {
    settings_.low_resolution = low;
    double share_before = 1.0, error_before = 0.0;
    for (const float threshold : {0.0f, 0.1f, 4.0f}) {
      // All that the pool has is black and looks gathered: what no pass writes shows.
      settings_.low_resolution = Settings::LowResolution::none;
      diffuse(g, dark);
      settings_.low_resolution = low;
      settings_.discontinuity = threshold;
      const Light found = diffuse(g, host);
      double error = 0, share = 0;
      for (size_t i = 0; i < all.size(); ++i) {
        error += glm::dot(found[i] - all[i], found[i] - all[i]);
        share += gathered_[i] ? 1.0 / static_cast<double>(all.size()) : 0.0;
        if (gathered_[i]) {
          ASSERT_EQ(found[i], all[i]) << i;
        }
      }
      error = std::sqrt(error / power);
      if (threshold == 0.1f) {
        EXPECT_LT(share, 0.3);
        EXPECT_GT(share, 0.01);
        EXPECT_LT(error, low == Settings::LowResolution::half ? 0.04 : 0.08);
      }
      EXPECT_LE(share, share_before);
      EXPECT_GE(error, error_before);
      share_before = share;
      error_before = error;
    }
  }
}

TEST_F(IndirectLightsTest, RandomPlacesChangeWithTheSeedAndOthersDoNot) {
  LitHost host(room, {kSpot, kSun}, kRoomBounds);
  settings_.negative_lights = 50;
  const CpuGBuffer g = cast_g_buffer(room, {31, 17}, 0.9, {0, 0.1, 5.5});
  EXPECT_EQ(diffuse(g, host, 1), diffuse(g, host, 2));
  settings_.placing = Settings::Placing::random;
  EXPECT_NE(diffuse(g, host, 1), diffuse(g, host, 2));
}

TEST_F(IndirectLightsTest, WithoutLightsItIsDark) {
  LitHost host(room, {}, kRoomBounds);
  settings_.negative_lights = 50;
  for (const auto low : {Settings::LowResolution::none, Settings::LowResolution::half}) {
    settings_.low_resolution = low;
    const CpuGBuffer g = cast_g_buffer(room, {5, 3}, 0.9, {0, 0.1, 5.5});
    for (const glm::dvec3& value : diffuse(g, host)) EXPECT_EQ(value, glm::dvec3(0));
  }
}

TEST_F(IndirectLightsTest, WithoutAHostItFails) {
  const CpuGBuffer g = cast_g_buffer(room, {8, 8}, 0.9, {0, 0.1, 5.5});
  const auto result = system().run([&](VkCommandBuffer commands) {
    Frame frame = context().record(commands);
    IndirectLights().render(frame, {.view = g.view, .g_buffer = g.upload(recorder())});
    return frame.finish();
  });
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().kind, ErrorKind::usage);
}

}  // namespace
}  // namespace lueur
