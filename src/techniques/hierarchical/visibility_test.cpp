// SPDX-License-Identifier: MIT
// Obstacles between what the camera sees: FDP 4, "visibility computation".
#include <cmath>

#include "techniques/hierarchical/box_fixture.h"

namespace lueur {
namespace {

// A floor, seen from above, a glowing box at its left and, where asked for, a wall across its
// middle.
const SolidBox kFloor{{-3, -0.5f, -3}, {3, 0, 3}};
const SolidBox kLamp{{-2.6f, 0, -1}, {-2.2f, 0.8f, 1}, 1};
const SolidBox kWall{{-0.2f, 0, -2.9f}, {0.2f, 1.6f, 2.9f}};

class VisibilityTest : public HierarchicalTest {
 protected:
  struct Room {
    std::vector<SolidBox> boxes;
    CpuGBuffer g;
  };
  // From above; the eye's place and field of view say how much is seen.
  static Room room(bool with_wall, double eye_x = 0, double fov_rad = 0.9) {
    Room r{{kFloor, kLamp}, {}};
    if (with_wall) r.boxes.push_back(kWall);
    const glm::dmat3 down(1, 0, 0, 0, 0.2, -std::sqrt(0.96), 0, std::sqrt(0.96), 0.2);
    r.g = cast_g_buffer(scene_of(r.boxes), {192, 128}, fov_rad, {eye_x, 7, 1.4}, down);
    return r;
  }

  Frames frame_of(const Room& r, Settings::Visibility visibility,
                  std::vector<PunctualLight> lights = {}) {
    Settings s = settings_;
    s.visibility = visibility;
    BoxHost host(r.boxes, std::move(lights));
    Hierarchical technique(s);
    return next_frame(technique, r.g, {.cut = true, .host = &host});
  }
  Light light_of(const Room& r, Settings::Visibility visibility,
                 std::vector<PunctualLight> lights = {}) {
    return frame_of(r, visibility, std::move(lights)).diffuse;
  }

  // What the light shows reaches the floor right of `from_x` without the wall, and not with it.
  void expect_wall_blocks(const PunctualLight& light, double eye_x, double fov_rad, double from_x) {
    settings_.sources = Settings::Sources::lights;
    settings_.visibility_steps = 32;  // shorter than the wall is wide
    for (const bool with_wall : {true, false}) {
      const Room r = room(with_wall, eye_x, fov_rad);
      const double open =
          floor_mean(r, light_of(r, Settings::Visibility::none, {light}), from_x, 2.6);
      const double tested =
          floor_mean(r, light_of(r, Settings::Visibility::first_bounce, {light}), from_x, 2.6);
      EXPECT_GT(open, 1e-3);
      EXPECT_NEAR(tested / open, with_wall ? 0.0 : 1.0, with_wall ? 0.02 : 0.05);
    }
  }

  // Mean over the floor between two x, away from edges.
  static double floor_mean(const Room& r, const Light& light, double from_x, double to_x) {
    double sum = 0, count = 0;
    for (size_t i = 0; i < light.size(); ++i) {
      const glm::dmat4 world_from_view = glm::inverse(glm::dmat4(view_matrix(r.g)));
      const glm::dvec3 p(world_from_view * glm::dvec4(r.g.position_view[i], 1));
      if (r.g.depth[i] == 0 || std::abs(p.y) > 1e-3 || std::abs(p.z) > 1.5) continue;
      if (p.x < from_x || p.x > to_x) continue;
      sum += light[i].x;
      ++count;
    }
    EXPECT_GT(count, 100);
    return sum / count;
  }
  static glm::mat4 view_matrix(const CpuGBuffer& g) {
    glm::mat4 m;
    for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = g.view.view_from_world[static_cast<size_t>(i)];
    return m;
  }

  Settings settings_;
};

TEST_F(VisibilityTest, AClosedWallLetsNothingThrough) {
  const Room r = room(true);
  const double open = floor_mean(r, light_of(r, Settings::Visibility::none), 0.6, 2.6);
  EXPECT_GT(open, 1e-3);
  for (const auto voxelizer : {Settings::Voxelizer::compute, Settings::Voxelizer::raster}) {
    settings_.voxelizer = voxelizer;
    EXPECT_LT(floor_mean(r, light_of(r, Settings::Visibility::first_bounce), 0.6, 2.6),
              0.02 * open);
  }
}

TEST_F(VisibilityTest, NorDoesTheFloorReflectWhatIsBehindIt) {
  settings_.glossy = true;
  for (const bool with_wall : {true, false}) {
    Room r = room(with_wall);
    r.g.reflectance.assign(r.g.depth.size(), glm::vec4(1));  // GGX, as rough as can be
    const double open = floor_mean(r, frame_of(r, Settings::Visibility::none).specular, 0.6, 2.6);
    const double tested =
        floor_mean(r, frame_of(r, Settings::Visibility::first_bounce).specular, 0.6, 2.6);
    EXPECT_GT(open, 1e-4);
    EXPECT_NEAR(tested / open, with_wall ? 0.0 : 1.0, with_wall ? 0.02 : 0.05);
  }
}

TEST_F(VisibilityTest, NothingIsBlockedWhereNothingStands) {
  for (const bool with_wall : {false, true}) {
    const Room r = room(with_wall);
    const double open = floor_mean(r, light_of(r, Settings::Visibility::none), -1.9, -0.6);
    const double tested =
        floor_mean(r, light_of(r, Settings::Visibility::first_bounce), -1.9, -0.6);
    EXPECT_NEAR(tested / open, 1.0, 0.03) << (with_wall ? "with" : "without") << " wall";
  }
}

// A flat, rough-free floor has no speckle of its own: pixel by pixel, little is lost.
TEST_F(VisibilityTest, AFloorDoesNotShadeItself) {
  const Room r = room(false);
  const Light open = light_of(r, Settings::Visibility::none);
  const Light tested = light_of(r, Settings::Visibility::first_bounce);
  int dark = 0, lit = 0;
  for (size_t i = 0; i < open.size(); ++i) {
    if (r.g.depth[i] == 0 || r.g.normal[i].y < 0.5f || open[i].x < 5e-3) continue;
    ++lit;
    if (tested[i].x < 0.8 * open[i].x) ++dark;
  }
  EXPECT_GT(lit, 1000);
  EXPECT_LT(dark, lit / 100);
}

// A light shines on the lamp's right side, past which its cone ends: its own voxels do not reach to
// the wall, but the camera's do.
TEST_F(VisibilityTest, TheCamerasVoxelsBlockWhatALightShows) {
  settings_.light_view_px = 96;
  expect_wall_blocks({.kind = PunctualLight::Kind::spot,
                      .position = {-1.0f, 1.2f, 0},
                      .direction = {-0.8320503f, -0.5547002f, 0},
                      .outer_cone_rad = 0.3f},
                     0.0, 0.9, 0.6);
}

// The camera sees the right of the room only, but the light all of it.
TEST_F(VisibilityTest, ALightsVoxelsBlockWhatTheCameraDoesNotSee) {
  settings_.light_view_px = 192;
  expect_wall_blocks({.kind = PunctualLight::Kind::spot,
                      .position = {-1.0f, 3.5f, 0},
                      .direction = {0, -1, 0},
                      .outer_cone_rad = 1.0f},
                     1.9, 0.22, 1.5);
}

// The sun shines over a block onto a glowing floor, and the block's far side, of which it sees the
// back, receives what it shows. Nothing is between, down to where the two meet.
TEST_F(VisibilityTest, ASideThatTheLightSeesTheBackOfKeepsItsLight) {
  settings_.sources = Settings::Sources::lights;
  settings_.light_view_px = 256;
  settings_.voxel_slices = Settings::VoxelSlices::of_128;
  settings_.samples = 128;
  Room r{{kFloor, {{-2.4f, 0, -2.9f}, {-0.9f, 1.2f, 2.9f}}}, {}};
  r.boxes[0].radiance = 1;
  const glm::dmat3 left(0, 0, -1, -0.3, std::sqrt(0.91), 0, std::sqrt(0.91), 0.3, 0);
  r.g = cast_g_buffer(scene_of(r.boxes), {192, 128}, 0.9, {2.4, 1.6, 0}, left);
  const PunctualLight sun{.kind = PunctualLight::Kind::directional, .direction = {0.6f, -0.8f, 0}};
  const Light open = light_of(r, Settings::Visibility::none, {sun});
  const Light tested = light_of(r, Settings::Visibility::first_bounce, {sun});
  double sum[2] = {}, count = 0;
  for (size_t i = 0; i < open.size(); ++i) {
    const glm::dvec4 p =
        glm::inverse(glm::dmat4(view_matrix(r.g))) * glm::dvec4(r.g.position_view[i], 1);
    if (r.g.depth[i] == 0 || std::abs(p.x + 0.9) > 1e-3 || p.y > 0.4 || std::abs(p.z) > 1) continue;
    sum[0] += open[i].x;
    sum[1] += tested[i].x;
    ++count;
  }
  EXPECT_GT(count, 200);
  EXPECT_GT(sum[0] / count, 1e-2);
  EXPECT_NEAR(sum[1] / sum[0], 1.0, 0.05);
}

// Before a glowing wall most samples have a ray to march, of many steps. A CPU would cut the loops
// of a thread short, and with them light, if it took more than one pixel.
TEST_F(VisibilityTest, ManyStepsLoseNoLight) {
  settings_.sources = Settings::Sources::lights;
  settings_.light_view_px = 512;
  settings_.samples = 192;
  const PunctualLight light{.kind = PunctualLight::Kind::spot,
                            .position = {2.8f, 1.0f, 0},
                            .direction = {-1, 0, 0},
                            .outer_cone_rad = 1.0f};
  Room r{{kFloor, kWall}, {}};
  r.boxes[1].radiance = 1;
  const glm::dmat3 down(1, 0, 0, 0, 0.2, -std::sqrt(0.96), 0, std::sqrt(0.96), 0.2);
  r.g = cast_g_buffer(scene_of(r.boxes), {192, 128}, 0.9, {0, 7, 1.4}, down);
  double mean[2];
  for (const bool many : {false, true}) {
    settings_.visibility_steps = many ? 128 : 16;
    mean[many] = floor_mean(r, light_of(r, Settings::Visibility::first_bounce, {light}), 0.6, 2.6);
  }
  EXPECT_GT(mean[0], 1e-2);
  EXPECT_NEAR(mean[1] / mean[0], 1.0, 0.03);
}

// What a CPU device would cut short is refused, and says what to lower.
TEST_F(VisibilityTest, MoreRoundsThanACpuTakesAreRefused) {
  if (!recorder().runs_on_cpu()) GTEST_SKIP() << "not a CPU device";
  settings_.samples = 256;
  settings_.visibility_steps = 128;
  settings_.visibility = Settings::Visibility::first_bounce;
  const Room r = room(true);
  BoxHost host(r.boxes, {});
  const auto result = system().run([&](VkCommandBuffer commands) {
    Frame frame = context().record(commands);
    Hierarchical(settings_).render(
        frame, {.view = r.g.view, .g_buffer = r.g.upload(recorder()), .host = &host});
    return frame.finish();
  });
  ASSERT_FALSE(result.ok());
  EXPECT_NE(result.error().message.find("lower visibility_steps"), std::string::npos);
}

TEST_F(VisibilityTest, WithoutTrianglesItFails) {
  const Room r = room(false);
  const auto result = system().run([&](VkCommandBuffer commands) {
    Frame frame = context().record(commands);
    Settings s;
    s.visibility = Settings::Visibility::all_bounces;
    Hierarchical(s).render(frame, {.view = r.g.view, .g_buffer = r.g.upload(recorder())});
    return frame.finish();
  });
  ASSERT_FALSE(result.ok());
  EXPECT_NE(result.error().message.find("visibility"), std::string::npos);
}

}  // namespace
}  // namespace lueur
