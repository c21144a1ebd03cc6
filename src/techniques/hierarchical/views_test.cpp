// SPDX-License-Identifier: MIT
// Sources that other views see, against the sum over all of their pixels in double precision.
#include <algorithm>
#include <cmath>

#include "techniques/hierarchical/hierarchical_fixture.h"

namespace lueur {
namespace {

// An engine with lights that casts rays for what other views see. All lights light alike: the
// scene's radiance is what each of them shows.
class CastingHost final : public Host {
 public:
  CastingHost(CpuScene scene, std::vector<PunctualLight> lights)
      : scene_(std::move(scene)), lights_(std::move(lights)) {}
  GBuffer render_view(Frame& frame, const View& view, Extent extent,
                      const ViewContent& content) override {
    seen.push_back(seen_through(scene_, view, extent));
    asked.push_back(content.light);
    return seen.back().upload(frame.recorder());
  }
  std::span<const PunctualLight> lights() const override { return lights_; }
  Box bounds() const override { return {{-2, -1, -5}, {3, 3, 1}}; }
  std::span<const TriangleBatch> triangles(Frame&) override { return {}; }

  std::vector<CpuGBuffer> seen;
  std::vector<int32_t> asked;

 private:
  CpuScene scene_;
  std::vector<PunctualLight> lights_;
};

// HSSIL (4) with (2), from all pixels of other views to each pixel of `g`.
std::vector<glm::dvec3> sum_from(const std::vector<CpuGBuffer>& views, const CpuGBuffer& g) {
  std::vector<glm::dvec3> result(g.depth.size(), glm::dvec3(0));
  const glm::dmat4 to_world = world_from_view(g.view);
  for (const CpuGBuffer& view : views) {
    const glm::dmat4 from = world_from_view(view.view);
    const double pixel_area = 4 / double(view.view.clip_from_view[0]) /
                              std::abs(double(view.view.clip_from_view[5])) /
                              (view.extent.width * view.extent.height);
    for (size_t j = 0; j < view.depth.size(); ++j) {
      if (view.depth[j] == 0) continue;
      const glm::dvec3 q(from * glm::dvec4(view.position_view[j], 1)), m(view.normal[j]);
      const double z = -view.position_view[j].z;
      const double facing = -glm::dot(m, q - glm::dvec3(from[3])) / z;
      const double ds = z * z * pixel_area * std::min(1 / std::max(facing, 1e-9), 20.0);
      for (size_t i = 0; i < g.depth.size(); ++i) {
        if (g.depth[i] == 0) continue;
        const glm::dvec3 d = q - glm::dvec3(to_world * glm::dvec4(g.position_view[i], 1));
        const double r = glm::length(d);
        const double cos_here = std::max(glm::dot(glm::dvec3(g.normal[i]), d) / r, 0.0);
        const double disc = std::max(-glm::dot(m, d) / r, 0.0) * ds / kPi;
        result[i] += glm::dvec3(view.source[j]) * (disc * cos_here / (r * r + disc));
      }
    }
  }
  return result;
}

class ViewsTest : public HierarchicalTest {
 protected:
  ViewsTest() {
    settings_.start = Settings::Start::full;
    settings_.filter = false;
    settings_.temporal = 0;
    settings_.samples = 256;
    settings_.levels = 1;
    settings_.radius = 9;  // as many pixels as samples: what is left is the averaging of levels
    settings_.light_view_px = 48;
    g_ = cast_g_buffer(corner_room, {48, 36}, 1.2, {0.5, 0.2, 0.5});
  }
  // The mean of many patterns of samples.
  Light mean_of(CastingHost& host, std::vector<View> side_views = {}) {
    constexpr uint32_t kFrames = 16;
    Light mean(g_.depth.size(), glm::dvec3(0));
    Hierarchical technique(settings_);
    for (uint32_t i = 0; i < kFrames; ++i) {
      host.seen.clear();
      host.asked.clear();
      const Light light =
          next_frame(technique, g_, {.seed = i, .side_views = side_views, .host = &host}).diffuse;
      for (size_t k = 0; k < mean.size(); ++k) mean[k] += light[k] / double{kFrames};
    }
    return mean;
  }

  CpuGBuffer g_;
  Settings settings_;
};

// Rings of this width lose 5 to 10 % by the averaging of levels: see the README's table.
TEST_F(ViewsTest, LightsGiveTheSumOverTheirViews) {
  settings_.sources = Settings::Sources::lights;
  for (const float cone : {0.8f, 1.5f}) {
    CastingHost host(corner_room, {{.kind = PunctualLight::Kind::spot,
                                    .position = {0.6f, 1.5f, -1.5f},
                                    .direction = {-0.2747211f, -0.9615240f, 0.0f},
                                    .outer_cone_rad = cone}});
    const Light light = mean_of(host);
    EXPECT_EQ(host.asked, std::vector<int32_t>(cone < 1 ? 1 : 5, 0));
    EXPECT_LT(relative_rmse(light, sum_from(host.seen, g_)), 0.1) << cone;
  }
}

TEST_F(ViewsTest, EachLightIsAskedForItself) {
  settings_.sources = Settings::Sources::lights;
  const PunctualLight spot{.kind = PunctualLight::Kind::spot,
                           .position = {0.6f, 1.5f, -1.5f},
                           .direction = {0, -1, 0},
                           .outer_cone_rad = 0.8f};
  CastingHost one(corner_room, {spot}), two(corner_room, {spot, spot});
  const Light single = mean_of(one), both = mean_of(two);
  EXPECT_EQ(two.asked, (std::vector<int32_t>{0, 1}));
  Light twice = single;
  for (glm::dvec3& l : twice) l *= 2.0;
  EXPECT_LT(relative_rmse(both, twice), 2.0 / 1024);
}

// What glows is seen by the camera, beside what the lights show.
TEST_F(ViewsTest, WithoutLightsTheCameraGivesAll) {
  CastingHost host(corner_room, {});
  settings_.sources = Settings::Sources::lights;
  const Light by_lights = mean_of(host);
  EXPECT_TRUE(host.asked.empty());
  settings_.sources = Settings::Sources::camera;
  EXPECT_EQ(by_lights, mean_of(host));
}

// A side camera that sees a wall which the main camera does not: its light arrives, and where both
// have light it is the larger one.
TEST_F(ViewsTest, SideCamerasBringHiddenLight) {
  const CpuScene scene = [](const glm::dvec3& o, const glm::dvec3& d) -> std::optional<CpuHit> {
    const double t_floor = d.y < 0 ? (-1 - o.y) / d.y : 1e30;
    const double t_wall = d.z > 0 ? (2 - o.z) / d.z : 1e30;
    if (t_floor > 1e29 && t_wall > 1e29) return std::nullopt;
    if (t_wall < t_floor) return CpuHit{o + t_wall * d, {0, 0, -1}, glm::dvec3(1)};
    return CpuHit{o + t_floor * d, {0, 1, 0}, glm::dvec3(0)};
  };
  g_ = cast_g_buffer(scene, {48, 36}, 1.4, {0, 0.5, 1.5});
  const glm::dmat3 backwards(-1, 0, 0, 0, 1, 0, 0, 0, -1);
  const CpuGBuffer side = cast_g_buffer(scene, {48, 36}, 1.6, {0, 0.5, -3}, backwards);
  CastingHost host(scene, {});
  const Light dark = mean_of(host);
  double most = 0;
  for (const glm::dvec3& l : dark) most = std::max(most, l.x);
  EXPECT_EQ(most, 0.0);
  const Light light = mean_of(host, {side.view});
  EXPECT_EQ(host.asked, std::vector<int32_t>{kAllLights});
  EXPECT_LT(relative_rmse(light, sum_from(host.seen, g_)), 0.1);
  // Warped, it is the other camera's own estimate, and only where that sees the floor.
  settings_.side_views = Settings::SideViews::warp;
  const Light warped = mean_of(host, {side.view});
  int known = 0;
  for (size_t i = 0; i < warped.size(); ++i) {
    if (warped[i].x == 0) continue;
    ++known;
    EXPECT_NEAR(warped[i].x / light[i].x, 1.0, 0.25) << "pixel " << i;
  }
  EXPECT_GT(known, 100);
}

}  // namespace
}  // namespace lueur
