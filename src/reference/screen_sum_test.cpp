// SPDX-License-Identifier: MIT
// `screen_unoccluded`: what the camera sees, summed as HSSIL writes it.
#include "reference/screen_sum.h"

#include <algorithm>
#include <cmath>

#include "reference/reference_fixture.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/shapes.h"

namespace lueur::reference {
namespace {

// A room with all that the sum can meet: slanted faces, several colours, what faces away, nothing.
Scene sum_scene() {
  Scene scene = scene_seen_from({0.5f, 1.1f, 2.4f}, {0, 0.4f, 0});
  scene.materials[0].base_color = glm::vec4(0.8f, 0.5f, 0.2f, 1);
  add_floor(scene, 1);
  add_quad(scene, {-1, 0, -1}, {2, 0, 0}, {0, 1, 0}, add_diffuse(scene, 0.6f, 0.3f));
  builtin::MeshBuilder builder;
  builtin::add_sphere(builder, {0.3f, 0.3f, 0}, 0.3f, 24);
  builtin::add_mesh(scene, builder.finish("ball"));
  add_light(scene, LightKind::point, 5.0f, {0.8f, 1.5f, 1});
  return scene;
}

// HSSIL (4) or (3) in double precision, from the depth, normal and source that come with it.
std::vector<double> sum_over_pixels(const Scene& scene, const Rendering& r, bool disc) {
  const auto rays = rays_of(scene, kShot);
  const ImageF &depth = layer(r, "depth"), &normal = layer(r, "normal"),
               &source = layer(r, "source");
  const double side =
      2 * std::tan(0.5 * static_cast<double>(scene.cameras[0].vertical_fov_rad)) / kShot.height;
  const auto position = [&](size_t i) {
    return rays[i].origin + static_cast<double>(depth.samples[i]) * rays[i].direction;
  };
  const auto normal_at = [&](size_t i) {
    return glm::dvec3(normal.samples[3 * i], normal.samples[3 * i + 1], normal.samples[3 * i + 2]);
  };
  std::vector<double> sums(3 * rays.size());
  for (size_t i = 0; i < rays.size(); ++i) {
    if (depth.samples[i] == 0.0f) continue;
    for (size_t j = 0; j < rays.size(); ++j) {
      if (depth.samples[j] == 0.0f) continue;
      const glm::dvec3 way = position(j) - position(i);
      const double r2 = glm::dot(way, way);
      if (!(r2 > 0)) continue;
      const double cos_x = std::max(glm::dot(normal_at(i), way) / std::sqrt(r2), 0.0);
      const double cos_y = std::max(-glm::dot(normal_at(j), way) / std::sqrt(r2), 0.0);
      const double z = static_cast<double>(depth.samples[j]);
      // The ray is 1 long along the axis, so cos(alpha) / cos(beta) is 1 / -(n . ray), at most 20.
      const double facing = std::max(-glm::dot(normal_at(j), rays[j].direction), 1.0 / 20);
      const double ds = side * side * z * z / facing;
      const double big_r2 = cos_y * ds / kPi;
      const double factor = big_r2 * cos_x / (disc ? r2 + big_r2 : r2);
      for (size_t c = 0; c < 3; ++c)
        sums[3 * i + c] += factor * static_cast<double>(source.samples[3 * j + c]);
    }
  }
  return sums;
}

TEST(ScreenUnoccluded, EqualsTheSumInDoublePrecision) {
  const Scene scene = sum_scene();
  for (const FormFactor factor : {FormFactor::disc, FormFactor::point}) {
    const Rendering r =
        rendered(scene, kShot, {.mode = Mode::screen_unoccluded, .spp = 0, .form_factor = factor});
    EXPECT_TRUE(r.complete);
    const auto sums = sum_over_pixels(scene, r, factor == FormFactor::disc);
    const ImageF& indirect = layer(r, "indirect");
    // Positions are floats of about 1 m, 1e-7 off, and the nearest neighbours, which weigh most,
    // 0.05 m apart at grazing angles, where an error of 1e-7 m counts against a height of 1e-3 m.
    for (size_t k = 0; k < sums.size(); ++k)
      EXPECT_NEAR(indirect.samples[k], sums[k], 1e-4 * sums[k] + 1e-7) << "channel " << k;
    EXPECT_GT(*std::max_element(sums.begin(), sums.end()), 0.1);
  }
}

// One pass sums every third of 576 pixels; seeds 0, 1 and 2 begin with different thirds.
TEST(ScreenUnoccluded, PartsMakeTheWhole) {
  const Scene scene = sum_scene();
  Settings settings{.mode = Mode::screen_unoccluded, .spp = 0};
  const ImageF whole = layer(rendered(scene, kShot, settings), "indirect");
  const Rendering all = rendered(scene, kShot, settings);
  const uint32_t passes = all.progress.spp_done / ScreenSum::kPixelsPerPass;
  ASSERT_GT(passes, 1u);
  settings.spp = 1;
  std::vector<double> mean(whole.samples.size());
  bool differ = false;
  for (settings.seed = 0; settings.seed < passes; ++settings.seed) {
    const Rendering part = rendered(scene, kShot, settings);
    EXPECT_EQ(part.progress.spp_done, ScreenSum::kPixelsPerPass);
    const ImageF& indirect = layer(part, "indirect");
    for (size_t k = 0; k < mean.size(); ++k)
      mean[k] += static_cast<double>(indirect.samples[k]) / passes;
    differ = differ || indirect.samples != whole.samples;
  }
  EXPECT_TRUE(differ);
  for (size_t k = 0; k < mean.size(); ++k)
    EXPECT_NEAR(mean[k], whole.samples[k], 1e-6 * mean[k]) << k;
  // More samples than there are pixels: all of them, once.
  settings = {.mode = Mode::screen_unoccluded, .spp = 1u << 20};
  EXPECT_EQ(layer(rendered(scene, kShot, settings), "indirect").samples, whole.samples);
}

// A glowing wall stands on a floor: the sum over its pixels approaches the polygon's closed form.
TEST(ScreenUnoccluded, WallOverFloor) {
  Scene scene = scene_seen_from({0, 1.5f, 2.6f}, {0, 0.3f, 0});
  scene.materials[0].base_color = glm::vec4(0, 0, 0, 1);
  scene.materials[0].specular = 0.0f;
  add_floor(scene, 1);
  add_quad(scene, {-1, 0, -1}, {2, 0, 0}, {0, 1, 0}, add_diffuse(scene, 0, 1));
  const Shot shot{64, 64};
  const Rendering r = rendered(scene, shot, {.mode = Mode::screen_unoccluded, .spp = 0});
  const ImageF &indirect = layer(r, "indirect"), &normal = layer(r, "normal");
  const auto wall = quad_corners({-1, 0, -1}, {2, 0, 0}, {0, 1, 0});
  // A pixel covers 4 cm at 3 m, and the wall 50 x 25 of them: its outline is off by at most half a
  // pixel at each of three sides, 1 to 2 % each, mostly cancelling; 0.5 m away the discs' own
  // approximation is R^2 / r^2 = 0.04^2 / (pi 0.5^2) = 0.2 %.
  int held = 0;
  for (const PixelRay& ray : rays_of(scene, shot)) {
    if (!(normal.at(ray.x, ray.y, 1) > 0.99f)) continue;
    const auto p = meet_plane(ray, {}, {0, 1, 0});
    if (p->z < -0.5) continue;
    const double exact = polygon_share(*p, {0, 1, 0}, wall);
    EXPECT_NEAR(indirect.at(ray.x, ray.y, 0), exact, 0.04 * exact) << p->x << ", " << p->z;
    ++held;
  }
  EXPECT_GT(held, 300);
}

TEST(ScreenUnoccluded, NoLightIsNoError) {
  Scene scene = scene_seen_from({0, 1, 1}, {0, 0, 0});
  add_floor(scene, 1);
  const Rendering r = rendered(scene, kShot, {.mode = Mode::screen_unoccluded, .spp = 0});
  EXPECT_TRUE(r.complete);
  for (const float v : layer(r, "indirect").samples) EXPECT_EQ(v, 0.0f);
}

}  // namespace
}  // namespace lueur::reference
