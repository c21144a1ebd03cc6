// SPDX-License-Identifier: MIT
// Shadows: where they must be, where they must not be, for each kind of light and of shadow map.
#include <cmath>

#include "renderer/renderer_fixture.h"
#include "scene/builtin/scene_builder.h"

namespace lueur {
namespace {

enum class Kind { point, narrow_spot, wide_spot, directional };
constexpr const char* kNames[] = {"point", "narrow_spot", "wide_spot", "directional"};

void PrintTo(Kind kind, std::ostream* out) {
  *out << kNames[static_cast<size_t>(kind)];
}

class ShadowTest : public RendererTest, public testing::WithParamInterface<Kind> {
 protected:
  // A light of the kind under test that shines from `position` to `target`, with all that the tests
  // look at inside of its inner cone.
  void add_tested_light(Scene& scene, const glm::vec3& position, const glm::vec3& target) {
    position_ = position;
    direction_ = glm::normalize(glm::dvec3(target - position));
    const Kind kind = GetParam();
    const LightKind light_kind = kind == Kind::directional ? LightKind::directional
                                 : kind == Kind::point     ? LightKind::point
                                                           : LightKind::spot;
    Light& light = add_light(scene, light_kind, 100.0f, position, target - position);
    light.inner_cone_rad = kind == Kind::wide_spot ? 1.3f : 0.9f;
    light.outer_cone_rad = kind == Kind::wide_spot ? 1.4f : 1.0f;
  }
  // Unit vector towards the light.
  glm::dvec3 to_light(const glm::dvec3& p) const {
    return GetParam() == Kind::directional ? -direction_ : glm::normalize(position_ - p);
  }
  double distance(const glm::dvec3& p) const {
    return GetParam() == Kind::directional ? 1e9 : glm::length(position_ - p);
  }
  // Radiance of a white surface that nothing shades.
  double lit(const glm::dvec3& p, const glm::dvec3& normal) const {
    const double r = GetParam() == Kind::directional ? 1.0 : distance(p);
    return 100.0 * std::max(glm::dot(normal, to_light(p)), 0.0) / (kPi * r * r);
  }

  glm::dvec3 position_, direction_;
};

INSTANTIATE_TEST_SUITE_P(Lights, ShadowTest,
                         testing::Values(Kind::point, Kind::narrow_spot, Kind::wide_spot,
                                         Kind::directional),
                         [](const auto& test) {
                           return std::string(kNames[static_cast<size_t>(test.param)]);
                         });

// A square between light and floor: beyond a seam of a few shadow texels all is light or shadow.
TEST_P(ShadowTest, ABlockerCastsAFullShadow) {
  constexpr double kHalf = 0.4, kAt = 0.8, kSeam = 0.04;
  Scene scene = scene_seen_from({0, 1.2f, 3.2f}, {0, 0, 0});
  add_floor(scene, 2);
  add_quad(scene, {-kHalf, kAt, kHalf}, {2 * kHalf, 0, 0}, {0, 0, -2 * kHalf});
  add_tested_light(scene, {0.3f, 2.2f, 0.1f}, {0, 0, 0});
  render(scene, {.extent = {96, 72}});
  int shaded = 0, bright = 0;
  for (const PixelRay& ray : rays()) {
    const auto p = meet_plane(ray, {}, {0, 1, 0});
    if (!p || glm::length(*p) > 1.5) continue;
    // The blocker hides the floor from the camera, too.
    const auto seen = meet_plane(ray, {0, kAt, 0}, {0, 1, 0});
    if (seen && std::abs(seen->x) < kHalf + 0.05 && std::abs(seen->z) < kHalf + 0.05) continue;
    const glm::dvec3 l = to_light(*p);
    const glm::dvec3 on_blocker = *p + l * (kAt / l.y);
    const double out = std::max(std::abs(on_blocker.x), std::abs(on_blocker.z)) - kHalf;
    const double exact = lit(*p, {0, 1, 0});
    const double source = static_cast<double>(luminance_at("source", ray));
    if (out < -kSeam) {
      ASSERT_EQ(source, 0.0) << "at " << p->x << ", " << p->z;
      ++shaded;
    } else if (out > kSeam) {
      ASSERT_NEAR(source, exact, kHalfError * exact) << "at " << p->x << ", " << p->z;
      ++bright;
    }
  }
  EXPECT_GT(shaded, 100);
  EXPECT_GT(bright, 100);
}

// A wall that stands on the floor: behind it is no light, down to where the two meet.
TEST_P(ShadowTest, NoLightLeaksBehindAWall) {
  Scene scene = scene_seen_from({0, 1.5f, 2.5f}, {0, 0, 0.3f});
  add_floor(scene, 2);
  // A sheet, seen by the camera from its back, which is not drawn into the camera's image.
  add_quad(scene, {2, 0, 0}, {-4, 0, 0}, {0, 2, 0});
  add_tested_light(scene, {0, 1.2f, -1.5f}, {0, 0, 0});
  render(scene);
  int shaded = 0;
  for (const PixelRay& ray : rays()) {
    const auto p = meet_plane(ray, {}, {0, 1, 0});
    // The light's own height is below the wall's: nothing behind is reached.
    if (!p || std::abs(p->x) > 1.0 || p->z > 1.5 || p->z < 0.005) continue;
    ASSERT_EQ(luminance_at("source", ray), 0.0f) << "at " << p->x << ", " << p->z;
    ++shaded;
  }
  EXPECT_GT(shaded, 500);
}

// A plane alone under light from straight above to grazing: no pixel shades itself.
TEST_P(ShadowTest, APlaneDoesNotShadeItself) {
  for (int degrees = 0; degrees <= 80; degrees += 10) {
    const double angle = degrees * kPi / 180;
    Scene scene = scene_seen_from({0, 2.5f, 0.1f}, {0, 0, 0});
    add_floor(scene, 3);
    add_tested_light(scene, glm::vec3(3.0 * std::sin(angle), 3.0 * std::cos(angle), 0), {0, 0, 0});
    render(scene, {.extent = {96, 72}});
    int off = 0, all = 0;
    for (const PixelRay& ray : rays()) {
      const auto p = meet_plane(ray, {}, {0, 1, 0});
      if (!p || glm::length(*p) > 0.8) continue;
      const double exact = lit(*p, {0, 1, 0});
      const double source = static_cast<double>(luminance_at("source", ray));
      // At 80 degrees the cosine magnifies the error of a 16-bit normal by its tangent.
      const double tolerance = kHalfError + 5e-5 * std::tan(std::acos(to_light(*p).y));
      off += std::abs(source - exact) > tolerance * exact;
      ++all;
    }
    EXPECT_GT(all, 1000);
    EXPECT_EQ(off, 0) << "of " << all << " pixels at " << degrees << " degrees";
  }
}

// A plane turned away from all axes, under light from the side, and right above it from a map that
// does not face it.
TEST_P(ShadowTest, ATiltedPlaneDoesNotShadeItself) {
  const glm::vec3 normal = glm::normalize(glm::vec3(0.3f, 0.8f, 0.5f));
  const glm::vec3 u = glm::normalize(glm::cross(glm::vec3(0.2f, 1, 0.7f), normal));
  const glm::vec3 v = glm::cross(normal, u);
  for (const auto& [position, target] : {std::pair(glm::vec3(-1.5f, 2.2f, -0.4f), glm::vec3(0)),
                                         std::pair(2.0f * normal, 0.5f * (u + v))}) {
    Scene scene = scene_seen_from(2.5f * normal, {0, 0, 0});
    add_quad(scene, -2.0f * (u + v), 4.0f * u, 4.0f * v);
    add_tested_light(scene, position, target);
    render(scene);
    int off = 0, all = 0;
    for (const PixelRay& ray : rays()) {
      const auto p = meet_plane(ray, {}, normal);
      if (!p || glm::length(*p) > 0.7) continue;
      const double exact = lit(*p, normal);
      const double tangent = std::tan(std::acos(glm::dot(to_light(*p), glm::dvec3(normal))));
      off += std::abs(static_cast<double>(luminance_at("source", ray)) - exact) >
             (kHalfError + 5e-5 * tangent) * exact;
      ++all;
    }
    EXPECT_GT(all, 500);
    EXPECT_EQ(off, 0) << "of " << all << " pixels below " << position.x << ", " << position.y;
  }
}

// A texture of which one half is a hole: camera and light see through it.
TEST_P(ShadowTest, MasksLetLightThrough) {
  constexpr float kHalf = 0.6f, kAt = 0.7f;
  Scene scene = scene_seen_from({0, 2.8f, 0.2f}, {0, 0, 0});
  Texture texture;
  texture.width = texture.height = 64;
  for (uint32_t i = 0; i < 64 * 64; ++i) {
    const uint8_t alpha = i % 64 < 32 ? 255 : 0;
    texture.rgba.insert(texture.rgba.end(), {255, 255, 255, alpha});
  }
  scene.textures.push_back(texture);
  const int32_t mask = builtin::add_material(scene, "mask", glm::vec3(1.0f), 1.0f);
  scene.materials.back().base_color_texture = 0;
  scene.materials.back().alpha_mode = AlphaMode::mask;
  add_floor(scene, 2);
  add_quad(scene, {-kHalf, kAt, kHalf}, {2 * kHalf, 0, 0}, {0, 0, -2 * kHalf}, mask);
  add_tested_light(scene, {-1.2f, 2.2f, 0}, {0, 0, 0});
  render(scene);
  const double near_m = static_cast<double>(scene.cameras[0].near_m);
  int mask_seen = 0, shaded = 0, through = 0;
  for (const PixelRay& ray : rays()) {
    const auto on_mask = meet_plane(ray, {0, kAt, 0}, {0, 1, 0});
    const auto on_floor = meet_plane(ray, {}, {0, 1, 0});
    ASSERT_TRUE(on_mask && on_floor);
    if (std::abs(on_mask->x) < 0.05 || std::abs(std::abs(on_mask->z) - kHalf) < 0.05 ||
        std::abs(std::abs(on_mask->x) - kHalf) < 0.05)
      continue;
    // Where the camera looks: at the left half of the mask, or at the floor.
    const bool sees_mask = on_mask->x < 0 && on_mask->x > -kHalf && std::abs(on_mask->z) < kHalf;
    const glm::dvec3 p = sees_mask ? *on_mask : *on_floor;
    const double t = glm::length(p - ray.origin) / glm::length(ray.direction);
    ASSERT_NEAR(static_cast<double>(at("depth", ray).x), near_m / t, 1e-5 * near_m / t);
    mask_seen += sees_mask;
    if (sees_mask || std::abs(p.x) > 1.9 || std::abs(p.z) > 1.9) continue;
    const glm::dvec3 l = to_light(p);
    const glm::dvec3 crossing = p + l * (static_cast<double>(kAt) / l.y);
    if (std::abs(crossing.x) < 0.05 || std::abs(std::abs(crossing.x) - kHalf) < 0.05 ||
        std::abs(std::abs(crossing.z) - kHalf) < 0.05)
      continue;
    const bool in_mask = std::abs(crossing.x) < kHalf && std::abs(crossing.z) < kHalf;
    const double exact = in_mask && crossing.x < 0 ? 0.0 : lit(p, {0, 1, 0});
    ASSERT_NEAR(static_cast<double>(luminance_at("source", ray)), exact, kHalfError * exact)
        << "at " << p.x << ", " << p.z;
    shaded += exact == 0.0;
    through += in_mask && crossing.x > 0;
  }
  EXPECT_GT(mask_seen, 100);
  EXPECT_GT(shaded, 50);
  EXPECT_GT(through, 100);
}

}  // namespace
}  // namespace lueur
