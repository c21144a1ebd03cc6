// SPDX-License-Identifier: MIT
// Motion from end to end: a scene file with a moving camera, a floor that stands and a plate that
// flies and turns over it. The motion in the EXR files of consecutive frames leads each point to
// where it was, by formulas of the test's own.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>

#include "image/exr.h"
#include "scene/gltf_export.h"
#include "support/cli.h"
#include "support/test_scene.h"

namespace lueur {
namespace {

constexpr uint32_t kWidth = 96, kHeight = 54;
constexpr double kPlateHeight = 1.0;          // metres above the floor
const glm::dvec3 kPlateSpeed(0.8, 0.0, 0.5);  // metres a second
constexpr double kPlateTurn = 0.7;            // radians a second, around y
const glm::dvec3 kEye(0.0, 4.0, 6.0), kEyeSpeed(-0.4, 0.2, 0.3);
constexpr double kFramesASecond = 10.0;

// Linear from 0 to 4 s.
void animate(Scene& scene, int32_t node, AnimationPath path, glm::vec4 begin, glm::vec4 end) {
  AnimationChannel channel;
  channel.node = node;
  channel.path = path;
  channel.times_s = {0.0f, 4.0f};
  channel.values = {begin, end};
  scene.animation.push_back(channel);
}

Scene moving_scene() {
  Scene scene = scene_seen_from(glm::vec3(kEye), {0, 0, 0});
  add_floor(scene, 20.0f);
  const float h = kPlateHeight;
  const int32_t plate = add_quad(scene, {-1.5f, h, 1.5f}, {3, 0, 0}, {0, 0, -3});
  add_light(scene, LightKind::point, 1000.0f, {0, 8, 0});
  const auto offset = [&](const glm::dvec3& speed) { return glm::vec4(4.0 * speed, 0.0); };
  const glm::vec4 eye(glm::vec3(kEye), 0.0f);
  animate(scene, scene.cameras[0].node, AnimationPath::translation, eye, eye + offset(kEyeSpeed));
  animate(scene, plate, AnimationPath::translation, glm::vec4(0.0f), offset(kPlateSpeed));
  const auto half = static_cast<float>(0.5 * 4.0 * kPlateTurn);
  animate(scene, plate, AnimationPath::rotation, {0, 0, 0, 1},
          {0, std::sin(half), 0, std::cos(half)});
  return scene;
}

glm::dmat4 world_from_plate(double time_s) {
  return glm::rotate(glm::translate(glm::dmat4(1.0), time_s * kPlateSpeed), time_s * kPlateTurn,
                     glm::dvec3(0, 1, 0));
}

// What the layers of one frame say.
struct Seen {
  glm::dmat4 world_from_camera{1.0};
  Camera camera;
  ImageF depth, motion;

  // The point of each pixel.
  std::vector<glm::dvec3> points() const {
    std::vector<glm::dvec3> all;
    for (const PixelRay& ray : pixel_rays(camera, world_from_camera, kWidth, kHeight))
      all.push_back(ray.origin + static_cast<double>(depth.at(ray.x, ray.y, 0)) * ray.direction);
    return all;
  }
  // The place of a point in the picture.
  glm::dvec2 uv_of(const glm::dvec3& point) const {
    const glm::dvec3 in_view(glm::inverse(world_from_camera) * glm::dvec4(point, 1.0));
    const double tan_v = std::tan(0.5 * static_cast<double>(camera.vertical_fov_rad));
    const double tan_h = tan_v * kWidth / kHeight;
    return {0.5 - 0.5 * in_view.x / (in_view.z * tan_h),
            0.5 + 0.5 * in_view.y / (in_view.z * tan_v)};
  }
};

class CliMotion : public Cli {
 protected:
  Seen read(const Scene& scene, int frame) const {
    Seen seen;
    seen.camera = scene.cameras[0];
    const double time_s = frame / kFramesASecond;
    seen.world_from_camera =
        glm::translate(glm::dmat4(1.0), time_s * kEyeSpeed) *
        glm::dmat4(world_from_camera(pose(scene, 0.0f)[static_cast<size_t>(seen.camera.node)]));
    const auto layers = read_exr(folder_ / (std::to_string(frame) + ".exr"));
    EXPECT_TRUE(layers.ok());
    if (!layers.ok()) return seen;
    for (const ImageLayer& layer : *layers) {
      if (layer.name == "depth") seen.depth = layer.image;
      if (layer.name == "motion") seen.motion = layer.image;
    }
    return seen;
  }
};

bool is_at(double height, const glm::dvec3& point) {
  return std::abs(point.y - height) < 1e-3;
}

TEST_F(CliMotion, LeadsPointsToWhereTheyWere) {
  const Scene scene = moving_scene();
  ASSERT_TRUE(export_glb(scene, folder_ / "scene.glb").ok());
  ASSERT_EQ(run({"render", "scene.glb", "--size", "96x54", "--frames", "9-10", "--fps", "10",
                 "--technique", "none", "-o", "{frame}.exr"})
                .code,
            0);
  const Seen before = read(scene, 9), now = read(scene, 10);
  ASSERT_FALSE(testing::Test::HasFailure());
  const std::vector<glm::dvec3> points_before = before.points(), points = now.points();
  const glm::dmat4 plate_before_from_now =
      world_from_plate(0.9) * glm::inverse(world_from_plate(1.0));

  size_t on_plate = 0, followed = 0, same = 0;
  for (uint32_t y = 0; y < kHeight; ++y)
    for (uint32_t x = 0; x < kWidth; ++x) {
      const glm::dvec3 point = points[size_t{y} * kWidth + x];
      const bool moves = is_at(kPlateHeight, point);
      ASSERT_TRUE(moves || is_at(0.0, point)) << x << ", " << y << ": height " << point.y;
      on_plate += moves ? 1 : 0;
      const glm::dvec3 point_before =
          moves ? glm::dvec3(plate_before_from_now * glm::dvec4(point, 1.0)) : point;
      const glm::dvec2 motion(now.motion.at(x, y, 0), now.motion.at(x, y, 1));
      const glm::dvec2 uv = glm::dvec2((x + 0.5) / kWidth, (y + 0.5) / kHeight) - motion;
      // Half floats keep 11 bits of the motion, and a device may cut off what is beyond; the rest
      // is the rounding of single precision.
      const double bound = 0x1p-10 * glm::length(motion) + 1e-5;
      const glm::dvec2 expected = before.uv_of(point_before);
      ASSERT_NEAR(uv.x, expected.x, bound) << x << ", " << y << (moves ? " plate" : " floor");
      ASSERT_NEAR(uv.y, expected.y, bound) << x << ", " << y << (moves ? " plate" : " floor");

      // What the frame before shows there is the same surface, where the plate did not hide it.
      if (uv.x < 0.0 || uv.x >= 1.0 || uv.y < 0.0 || uv.y >= 1.0) continue;
      ++followed;
      const auto x_before = static_cast<uint32_t>(uv.x * kWidth);
      const auto y_before = static_cast<uint32_t>(uv.y * kHeight);
      const glm::dvec3 found = points_before[size_t{y_before} * kWidth + x_before];
      same += is_at(moves ? kPlateHeight : 0.0, found) ? 1 : 0;
    }
  EXPECT_GT(on_plate, 300u);
  EXPECT_GT(followed, size_t{kWidth} * kHeight * 9 / 10);
  // The plate moves by 2 pixels, so that its border of some 100 hides no more than 200.
  EXPECT_GT(same, followed - 200);
}

}  // namespace
}  // namespace lueur
