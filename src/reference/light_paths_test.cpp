// SPDX-License-Identifier: MIT
// Light in scenes with closed forms: one bounce, glowing triangles, punctual lights, and two
// estimators of one integral against each other.
#include "reference/light_paths.h"

#include <cmath>

#include "reference/reference_fixture.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/shapes.h"

namespace lueur::reference {
namespace {

constexpr Settings kOneBounce{.spp = 16};

using Polygon = std::vector<glm::dvec3>;

// A black floor that the camera looks at from a side, below anything that hangs above it.
Scene floor_scene() {
  Scene scene = scene_seen_from({0, 0.9f, 2.2f}, {0, 0.1f, 0});
  scene.materials[0].specular = 0.0f;
  scene.materials[0].base_color = glm::vec4(0, 0, 0, 1);
  add_floor(scene, 3);
  return scene;
}

// E/pi on the floor under glowing polygons; not where the camera sees something else.
std::function<std::optional<double>(size_t)> floor_under(
    const Scene& scene, const std::vector<std::pair<double, Polygon>>& lights) {
  const std::vector<PixelRay> rays = rays_of(scene, kShot);
  const Rendering seen = rendered(scene, kShot, {.mode = Mode::ambient, .spp = 8});
  const ImageF normal = layer(seen, "normal");
  return [=](size_t i) -> std::optional<double> {
    if (!(normal.samples[3 * i + 1] > 0.99f)) return std::nullopt;
    const auto p = meet_plane(rays[i], {}, {0, 1, 0});
    double sum = 0;
    for (const auto& [radiance, polygon] : lights)
      sum += radiance * polygon_share(*p, {0, 1, 0}, polygon);
    return sum;
  };
}

TEST(LightPaths, ParallelPlate) {
  Scene scene = floor_scene();
  const int32_t glow = add_diffuse(scene, 0, 3);
  add_quad(scene, {-0.8f, 1.2f, 0.3f}, {1.6f, 0, 0}, {0, 0, -0.9f}, glow);
  const auto plate = quad_corners({-0.8, 1.2, 0.3}, {1.6, 0, 0}, {0, 0, -0.9});
  expect_unbiased(estimates(scene, kShot, kOneBounce, kSeedCount),
                  floor_under(scene, {{3, plate}}));
}

// On the axis of a disc of radius a at height h: a^2 / (a^2 + h^2).
TEST(LightPaths, PointUnderADisc) {
  Scene scene = scene_seen_from({0.1f, 0.2f, 0.6f}, {0, 0, 0});
  scene.materials[0].specular = 0.0f;
  add_floor(scene, 1);
  const int32_t glow = add_diffuse(scene, 0, 1);
  builtin::MeshBuilder builder;
  builder.set_material(glow);
  constexpr int kRim = 256;
  constexpr double kRadius = 0.5, kHeight = 0.4;
  builder.add_fan({0, kHeight, 0}, kRim,
                  [](int k) {
                    const glm::vec2 c = builtin::unit_circle_point(k, kRim);
                    return glm::vec3(kRadius * static_cast<double>(c.x), kHeight,
                                     kRadius * static_cast<double>(c.y));
                  },
                  {0, -1, 0});
  builtin::add_mesh(scene, builder.finish("disc"));
  // One pixel, which looks at the point below the disc's centre.
  const Shot shot{1, 1};
  const Estimates found = estimates(scene, shot, {.spp = 256}, kSeedCount);
  const double exact = kRadius * kRadius / (kRadius * kRadius + kHeight * kHeight);
  // The rim of 256 corners has 1e-4 less area than the circle.
  EXPECT_NEAR(found.mean[0], exact, 5 * found.error[0] + 1e-4 * exact);
  EXPECT_LT(found.error[0], 1e-3 * exact);
}

// Small and bright is found by its triangles, what stands on the floor by both, as the densities of
// both kinds have no bound there. Nothing may be counted twice.
TEST(LightPaths, SmallEmitterAndOneThatTouchesTheFloor) {
  Scene scene = floor_scene();
  add_quad(scene, {-0.9f, 0.5f, 0.2f}, {0.04f, 0, 0}, {0, 0, -0.05f}, add_diffuse(scene, 0, 700));
  add_quad(scene, {-1, 0, -1}, {2, 0, 0}, {0, 0.6f, 0}, add_diffuse(scene, 0, 2));
  expect_unbiased(
      estimates(scene, kShot, kOneBounce, kSeedCount),
      floor_under(scene, {{700, quad_corners({-0.9, 0.5, 0.2}, {0.04, 0, 0}, {0, 0, -0.05})},
                          {2, quad_corners({-1, 0, -1}, {2, 0, 0}, {0, 0.6, 0})}}));
}

// A glowing room is found by the BRDF, and what stands in it hides as much of it as it is large.
TEST(LightPaths, EmitterInAGlowingRoom) {
  Scene scene = floor_scene();
  constexpr double kRoom = 0.75;
  builtin::MeshBuilder builder;
  builder.set_material(add_diffuse(scene, 0, kRoom));
  builtin::add_box(builder, {-4, -1, -4}, {4, 3, 4}, {.edge_m = 10.0f});
  builtin::add_mesh(scene, builder.finish("room"));
  add_quad(scene, {-1, 0, -1}, {2, 0, 0}, {0, 0.6f, 0}, add_diffuse(scene, 0, 2));
  const auto more =
      floor_under(scene, {{2 - kRoom, quad_corners({-1, 0, -1}, {2, 0, 0}, {0, 0.6, 0})}});
  expect_unbiased(estimates(scene, kShot, kOneBounce, kSeedCount),
                  [&](size_t i) -> std::optional<double> {
                    const auto value = more(i);
                    return value ? kRoom + *value : value;
                  });
}

// A chequered emitter glows in two of its quarters.
TEST(LightPaths, TexturedEmitter) {
  Scene scene = floor_scene();
  const int32_t glow = add_diffuse(scene, 0, 5);
  const uint8_t off = 0, on = 255;
  Texture texture{.width = 2, .height = 2, .rgba = {}, .nearest = true};
  for (const uint8_t v : {on, off, off, on})
    texture.rgba.insert(texture.rgba.end(), {v, v, v, 255});
  scene.textures.push_back(texture);
  scene.materials.back().emission_texture = 0;
  add_quad(scene, {-0.8f, 0.9f, 0.3f}, {1.6f, 0, 0}, {0, 0, -1.2f}, glow);
  const glm::dvec3 u(0.8, 0, 0), v(0, 0, -0.6), corner(-0.8, 0.9, static_cast<double>(0.3f));
  expect_unbiased(estimates(scene, kShot, kOneBounce, kSeedCount),
                  floor_under(scene, {{5, quad_corners(corner, u, v)},
                                      {5, quad_corners(corner + u + v, u, v)}}));
}

// One texel of 128 x 128 glows: the mean of the texture rounds to black, so no triangle is ever
// picked for it, and it is only found by chance. Nothing of it is lost.
TEST(LightPaths, EmitterWhoseMeanRoundsToBlack) {
  Scene scene = floor_scene();
  const int32_t glow = add_diffuse(scene, 0, 1);
  Texture texture{.width = 128, .height = 128, .rgba = {}, .nearest = true};
  texture.rgba.resize(size_t{4} * 128 * 128);
  for (size_t c = 0; c < 4; ++c) texture.rgba[4 * (64 * 128 + 64) + c] = 255;
  scene.textures.push_back(texture);
  scene.materials.back().emission_texture = 0;
  add_quad(scene, {-0.8f, 0.9f, 0.3f}, {1.6f, 0, 0}, {0, 0, -1.2f}, glow);
  // All of the quad lies within the texel.
  for (Vertex& v : scene.meshes.back().vertices) v.uv = glm::vec2(64.25f) / 128.0f + v.uv / 256.0f;
  expect_unbiased(estimates(scene, kShot, kOneBounce, kSeedCount),
                  floor_under(scene, {{1, quad_corners({-0.8, 0.9, static_cast<double>(0.3f)},
                                                       {1.6, 0, 0}, {0, 0, -1.2})}}));
}

// Holes of an alpha mask do not glow.
TEST(LightPaths, MaskedEmitter) {
  Scene scene = floor_scene();
  const int32_t glow = add_diffuse(scene, 0, 5);
  Texture texture{
      .width = 2, .height = 1, .rgba = {255, 255, 255, 255, 255, 255, 255, 0}, .nearest = true};
  scene.textures.push_back(texture);
  scene.materials.back().base_color_texture = 0;
  scene.materials.back().alpha_mode = AlphaMode::mask;
  add_quad(scene, {-0.8f, 0.9f, 0.3f}, {1.6f, 0, 0}, {0, 0, -1.2f}, glow);
  expect_unbiased(estimates(scene, kShot, kOneBounce, kSeedCount),
                  floor_under(scene, {{5, quad_corners({-0.8, 0.9, static_cast<double>(0.3f)},
                                                       {0.8, 0, 0}, {0, 0, -1.2})}}));
}

// A wall under lights of every kind, whose light the floor sees. The exact sum is over the wall.
TEST(LightPaths, ManyPunctualLights) {
  Scene scene = floor_scene();
  const int32_t white = add_diffuse(scene, 0.8f);
  add_quad(scene, {-1, 0.1f, -0.8f}, {2, 0, 0}, {0, 1.2f, 0}, white);
  add_light(scene, LightKind::point, 3.0f, {-0.7f, 0.6f, -0.2f});
  add_light(scene, LightKind::point, 9.0f, {0.9f, 1.6f, 0.4f});
  add_light(scene, LightKind::directional, 2.0f, {}, {0.3f, -0.5f, -1});
  add_light(scene, LightKind::point, 50.0f, {0, 0.6f, -1.5f});  // behind the wall
  Light& spot = add_light(scene, LightKind::spot, 12.0f, {0.3f, 0.8f, 1}, {0, 0, -1});
  spot.inner_cone_rad = 0.1f;
  spot.outer_cone_rad = 0.5f;
  const auto lit = [&](const glm::dvec3& p) {
    const glm::dvec3 n(0, 0, 1);
    const auto point = [&](double cd, const glm::dvec3& at) {
      const glm::dvec3 l = at - p;
      return cd * std::max(glm::dot(n, l), 0.0) / std::pow(glm::length(l), 3);
    };
    const glm::dvec3 from_spot = glm::normalize(p - glm::dvec3(0.3, 0.8, 1));
    const double inner = std::cos(0.1), outer = std::cos(0.5);
    const double ramp = std::clamp((-from_spot.z - outer) / (inner - outer), 0.0, 1.0);
    return point(3, {-0.7, 0.6, -0.2}) + point(9, {0.9, 1.6, 0.4}) +
           2.0 / std::sqrt(0.09 + 0.25 + 1) + ramp * ramp * point(12, {0.3, 0.8, 1});
  };
  // Gauss's rule over the wall, whose nearest point is 0.1 m off: its error is below 1e-5. Behind
  // the wall the floor sees other light.
  const Rule rule = gauss_legendre(64);
  const auto rays = rays_of(scene, kShot);
  const auto is_floor = floor_under(scene, {});
  const auto exact = [&](size_t i) -> std::optional<double> {
    if (!is_floor(i)) return std::nullopt;
    const glm::dvec3 x = *meet_plane(rays[i], {}, {0, 1, 0});
    if (x.z < -0.79) return std::nullopt;
    double sum = 0;
    for (size_t a = 0; a < rule.at.size(); ++a)
      for (size_t b = 0; b < rule.at.size(); ++b) {
        const glm::dvec3 y(-1 + 2 * rule.at[a], 0.1 + 1.2 * rule.at[b], -0.8);
        const glm::dvec3 way = y - x;
        const double r2 = glm::dot(way, way);
        sum += rule.weight[a] * rule.weight[b] * lit(y) * way.y * -way.z / (r2 * r2);
      }
    return 2.0 * 1.2 * 0.8 / (kPi * kPi) * sum;
  };
  expect_unbiased(estimates(scene, kShot, {.spp = 32}, kSeedCount), exact);
}

// Direct light is exact: a sphere under a point light and a directional one.
TEST(LightPaths, DirectLightOnASphere) {
  for (const bool directional : {false, true}) {
    Scene scene = scene_seen_from({0, 0, 4}, {0, 0, 0});
    scene.materials[0].specular = 0.0f;
    scene.materials[0].base_color = glm::vec4(0.25f, 0.5f, 1.0f, 1.0f);
    builtin::MeshBuilder builder;
    builtin::add_sphere(builder, glm::vec3(0.0f), 1.0f, 256);
    builtin::add_mesh(scene, builder.finish("ball"));
    const glm::dvec3 at(2, 3, 4);
    add_light(scene, directional ? LightKind::directional : LightKind::point, 10.0f, at, -at);
    const Shot shot{48, 48};
    const Rendering r = rendered(scene, shot, {.spp = 8});
    const ImageF &source = layer(r, "source"), &depth = layer(r, "depth");
    int lit = 0;
    for (const PixelRay& ray : rays_of(scene, shot)) {
      const double b = glm::dot(ray.origin, ray.direction),
                   a = glm::dot(ray.direction, ray.direction);
      const double d = b * b - a * (glm::dot(ray.origin, ray.origin) - 1);
      // At the silhouette the polygon and the ball part.
      if (d < 0.5) {
        EXPECT_TRUE(d > -0.1 || depth.samples[ray.index] == 0.0f);
        continue;
      }
      const glm::dvec3 p = ray.origin + ray.direction * ((-b - std::sqrt(d)) / a);
      EXPECT_NEAR(depth.samples[ray.index], glm::dot(p - ray.origin, glm::dvec3(0, 0, -1)), 1e-3);
      const glm::dvec3 l = directional ? glm::normalize(at) : at - p;
      const double cosine = glm::dot(p, glm::normalize(l));
      // Light that grazes a triangle's plane is a matter of the triangles.
      if (std::abs(cosine) < 0.05) continue;
      const double exact = 10 * std::max(cosine, 0.0) / kPi / (directional ? 1 : glm::dot(l, l));
      // 256 x 128 cells: normals are off by less than half of (pi / 128)^2 / 2 = 3e-4 and
      // positions by 3e-4 of 5 m.
      for (uint32_t c = 0; c < 3; ++c)
        EXPECT_NEAR(source.at(ray.x, ray.y, c), exact * std::pow(2.0, static_cast<int>(c) - 2),
                    1e-3 * exact + 5e-4);
      lit += exact > 0 ? 1 : 0;
    }
    EXPECT_GT(lit, 200);
  }
}

// A corner of three walls of which the camera sees everything, so that `screen` leaves nothing out.
// A quarter of one wall glows.
Scene corner_scene() {
  Scene scene = scene_seen_from({3, 3.2f, 3.4f}, {0.3f, 0.3f, 0.3f});
  scene.cameras[0].vertical_fov_rad = 0.4f;
  scene.materials[0].base_color = glm::vec4(0.7f, 0.7f, 0.7f, 1.0f);
  scene.materials[0].specular = 0.0f;
  add_quad(scene, {0, 0, 1}, {1, 0, 0}, {0, 0, -1});
  add_quad(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  scene.materials.push_back(scene.materials[0]);
  scene.materials[1].emission = glm::vec3(1.5f);
  scene.materials[1].emission_texture = 0;
  scene.textures.push_back({.name = {}, .width = 2, .height = 2, .rgba = {}, .nearest = true});
  scene.textures[0].rgba.assign(16, 0);
  for (size_t c = 0; c < 4; ++c) scene.textures[0].rgba[c] = 255;
  add_quad(scene, {0, 0, 1}, {0, 0, -1}, {0, 1, 0}, 1);
  return scene;
}

// With the same seeds the two even take the same paths; other seeds keep them independent.
TEST(LightPaths, ScreenEqualsPathWhereTheCameraSeesEverything) {
  Scene scene = corner_scene();
  add_light(scene, LightKind::point, 2.0f, {0.7f, 0.9f, 0.6f});
  add_light(scene, LightKind::directional, 1.0f, {}, {-1, -0.6f, -0.8f});
  for (const uint32_t bounces : {1u, 2u, 4u}) {
    Settings path = kOneBounce;
    path.bounces = bounces;
    Settings screen = path;
    screen.mode = Mode::screen;
    screen.seed = 1;
    expect_same(estimates(scene, kShot, path, kSeedCount),
                estimates(scene, kShot, screen, kSeedCount));
  }
}

// Where all light is emission, what reflects to the receiver does not matter, but its lobe still
// decides where path takes its samples.
TEST(LightPaths, ScreenEqualsPathOnGlossySurfacesUnderEmission) {
  Scene scene = corner_scene();
  for (Material& material : scene.materials) {
    material.specular = 1.0f;
    material.metallic = 0.5f;
    material.roughness = 0.4f;
  }
  Settings path = kOneBounce, screen = kOneBounce;
  screen.mode = Mode::screen;
  screen.seed = 1;
  expect_same(estimates(scene, kShot, path, kSeedCount),
              estimates(scene, kShot, screen, kSeedCount));
}

// With punctual light on gloss, `path` has the gloss of what it sees on top.
TEST(LightPaths, GlossAddsToPathOnly) {
  Scene scene = corner_scene();
  for (Material& material : scene.materials) {
    material.emission = glm::vec3(0.0f);
    material.specular = 1.0f;
    material.metallic = 0.8f;
    material.roughness = 0.4f;
  }
  add_light(scene, LightKind::point, 2.0f, {0.7f, 0.9f, 0.6f});
  Settings settings = kOneBounce;
  settings.spp = 64;
  const auto mean = [&](Mode mode) {
    settings.mode = mode;
    double sum = 0;
    for (const float v : layer(rendered(scene, kShot, settings), "indirect").samples)
      sum += static_cast<double>(v);
    return sum;
  };
  EXPECT_GT(mean(Mode::path), 1.5 * mean(Mode::screen));
}

// No colour leaks into another: red light on a green wall gives nothing.
TEST(LightPaths, ColoursMultiply) {
  Scene scene = floor_scene();
  const int32_t green = add_diffuse(scene, 0);
  scene.materials.back().base_color = glm::vec4(0, 0.8f, 0.5f, 1);
  add_quad(scene, {-1, 0, -0.8f}, {2, 0, 0}, {0, 1.2f, 0}, green);
  add_light(scene, LightKind::directional, 3.0f, {}, {0, 0, -1}).color = {1, 0, 0.5f};
  const ImageF indirect = layer(rendered(scene, kShot, {.spp = 64}), "indirect");
  const auto wall = floor_under(
      scene, {{0.5 * 3 * 0.5 / kPi,
               quad_corners({-1, 0, static_cast<double>(-0.8f)}, {2, 0, 0}, {0, 1.2, 0})}});
  double blue = 0, exact = 0;
  for (size_t i = 0; i < indirect.samples.size() / 3; ++i) {
    EXPECT_EQ(indirect.samples[3 * i], 0.0f);
    EXPECT_EQ(indirect.samples[3 * i + 1], 0.0f);
    if (!wall(i)) continue;
    blue += static_cast<double>(indirect.samples[3 * i + 2]);
    exact += *wall(i);
  }
  // 500 pixels of 64 samples, each off by less than its own size: 1 / sqrt(32000), five times.
  EXPECT_NEAR(blue, exact, 0.03 * exact);
}

}  // namespace
}  // namespace lueur::reference
