// SPDX-License-Identifier: MIT
// Surfaces as rays meet them: sides, mirrors, holes, normals, textures, cones.
#include <cmath>

#include "image/mip_chain.h"
#include "image/tone_map.h"
#include "reference/reference_fixture.h"
#include "scene/builtin/scene_builder.h"

namespace lueur::reference {
namespace {

constexpr Settings kFew{.spp = 8};

// A square of side 1 upright at z = 0, before a camera at z = 2 that looks straight at it.
Scene square_scene() {
  Scene scene = scene_seen_from({0, 0, 2}, {0, 0, 0});
  scene.materials[0].specular = 0.0f;
  add_quad(scene, {-0.5f, -0.5f, 0}, {1, 0, 0}, {0, 1, 0});
  return scene;
}
Node& square(Scene& scene) {
  return scene.nodes[static_cast<size_t>(scene.instances[0].node)];
}

// The middle pixel's value.
float middle(const ImageF& image, uint32_t channel = 0) {
  return image.at(kShot.width / 2, kShot.height / 2, channel);
}
float middle_depth(const Scene& scene) {
  return middle(layer(rendered(scene, kShot, kFew), "depth"));
}

TEST(Geometry, TheCameraSeesFrontsAndWhatIsDoubleSided) {
  Scene scene = square_scene();
  EXPECT_FLOAT_EQ(middle_depth(scene), 2.0f);
  square(scene).rotation = glm::angleAxis(static_cast<float>(kPi), glm::vec3(0, 1, 0));
  EXPECT_EQ(middle_depth(scene), 0.0f);
  scene.materials[0].double_sided = true;
  EXPECT_FLOAT_EQ(middle_depth(scene), 2.0f);
  // Its normal is turned to the camera, and it is lit from there.
  add_light(scene, LightKind::directional, 3.0f, {}, {0, 0, -1});
  const Rendering r = rendered(scene, kShot, kFew);
  EXPECT_NEAR(middle(layer(r, "normal"), 2), 1.0f, 1e-6f);
  EXPECT_NEAR(middle(layer(r, "source")), 3 / kPi, 1e-5);
}

TEST(Geometry, MirrorsKeepTheirFronts) {
  for (const glm::vec3& scale : {glm::vec3(-1, 1, 1), glm::vec3(1, -1, 1), glm::vec3(1, 1, -1)}) {
    Scene scene = square_scene();
    square(scene).scale = scale;
    add_light(scene, LightKind::directional, 3.0f, {}, {0, 0, -1});
    // Mirrored in its own plane it still faces the camera; across, it faces away.
    const bool faces = scale.z > 0;
    const Rendering r = rendered(scene, kShot, kFew);
    EXPECT_EQ(middle(layer(r, "depth")) > 0, faces);
    EXPECT_NEAR(middle(layer(r, "normal"), 2), faces ? 1.0f : 0.0f, 1e-6f);
    EXPECT_NEAR(middle(layer(r, "source")), faces ? 3 / kPi : 0.0, 1e-5);
    scene.materials[0].double_sided = true;
    EXPECT_NEAR(middle(layer(rendered(scene, kShot, kFew), "normal"), 2), 1.0f, 1e-6f);
  }
}

// A normal that is not scaled like positions: a slope of 1 in 2 under a scale of 2 along y.
TEST(Geometry, NormalsFollowTheInverseTranspose) {
  Scene scene = square_scene();
  for (Vertex& v : scene.meshes[0].vertices) v.normal = glm::normalize(glm::vec3(0, 1, 1));
  square(scene).scale = {1, 2, 1};
  const Rendering r = rendered(scene, kShot, kFew);
  EXPECT_NEAR(middle(layer(r, "normal"), 1) / middle(layer(r, "normal"), 2), 0.5f, 1e-5f);
}

// Light meets both sides of everything: a one-sided sheet that the camera does not see casts a
// shadow, and reflects.
TEST(Geometry, LightIsStoppedByBackFaces) {
  Scene scene = scene_seen_from({0, 1.5f, 1.5f}, {0, 0, 0});
  scene.materials[0].specular = 0.0f;
  add_floor(scene, 2);
  // Faces down: its back to the camera and to the light.
  add_quad(scene, {-0.5f, 0.5f, -0.5f}, {1, 0, 0}, {0, 0, 1});
  add_light(scene, LightKind::directional, 3.0f, {}, {0, -1, 0});
  const Rendering r = rendered(scene, kShot, kFew);
  EXPECT_GT(middle(layer(r, "depth")), 2.0f);
  EXPECT_EQ(middle(layer(r, "source")), 0.0f);
  EXPECT_LT(middle(layer(rendered(scene, kShot, {.mode = Mode::ambient, .spp = 64}), "occlusion")),
            0.6f);
}

// The right half of the square is a hole.
Texture half_transparent() {
  return {.name = {},
          .width = 2,
          .height = 1,
          .rgba = {255, 255, 255, 255, 255, 255, 255, 0},
          .nearest = true};
}
void cut(Scene& scene, int32_t material) {
  scene.textures = {half_transparent()};
  scene.materials[static_cast<size_t>(material)].base_color_texture = 0;
  scene.materials[static_cast<size_t>(material)].alpha_mode = AlphaMode::mask;
}

TEST(Geometry, TheCameraSeesThroughHoles) {
  Scene scene = square_scene();
  cut(scene, 0);
  const ImageF depth = layer(rendered(scene, kShot, kFew), "depth");
  EXPECT_GT(depth.at(10, 12, 0), 0.0f);
  EXPECT_EQ(depth.at(13, 12, 0), 0.0f);
  // A texture's alpha does nothing in opaque materials.
  scene.materials[0].alpha_mode = AlphaMode::opaque;
  EXPECT_GT(layer(rendered(scene, kShot, kFew), "depth").at(13, 12, 0), 0.0f);
  // Alpha at the cutoff is a surface.
  scene.materials[0].alpha_mode = AlphaMode::mask;
  scene.materials[0].alpha_cutoff = 0.0f;
  EXPECT_GT(layer(rendered(scene, kShot, kFew), "depth").at(13, 12, 0), 0.0f);
}

// A cut sheet over a floor; light falls through its right half.
Scene sheet_over_floor(bool double_sided) {
  Scene scene = scene_seen_from({0, 0.25f, 2.5f}, {0, 0, 0});
  scene.materials[0].specular = 0.0f;
  add_floor(scene, 1);
  const int32_t sheet = add_diffuse(scene, 0.5f);
  scene.materials.back().double_sided = double_sided;
  add_quad(scene, {-0.5f, 0.6f, 0.5f}, {1, 0, 0}, {0, 0, -1}, sheet);
  cut(scene, sheet);
  return scene;
}

TEST(Geometry, LightFallsThroughHoles) {
  for (const bool double_sided : {false, true}) {
    Scene scene = sheet_over_floor(double_sided);
    add_light(scene, LightKind::directional, 3.0f, {}, {0, -1, 0});
    const Rendering r = rendered(scene, kShot, kFew);
    int shaded = 0, lit = 0;
    for (const PixelRay& ray : rays_of(scene, kShot)) {
      const auto p = meet_plane(ray, {}, {0, 1, 0});
      if (!p || std::abs(p->z) > 0.45 || std::abs(p->x) > 0.45) continue;
      const bool under = p->x < 0;
      EXPECT_NEAR(layer(r, "source").at(ray.x, ray.y, 0), under ? 0 : 3 / kPi, 1e-5);
      ++(under ? shaded : lit);
    }
    EXPECT_GT(shaded, 2);
    EXPECT_GT(lit, 2);
  }
}

TEST(Geometry, PathsGoThroughHoles) {
  const Scene scene = sheet_over_floor(false);
  const auto rays = rays_of(scene, kShot);
  const ImageF normal = layer(rendered(scene, kShot, kFew), "normal");
  const auto half = quad_corners({-0.5, static_cast<double>(0.6f), 0.5}, {0.5, 0, 0}, {0, 0, -1});
  expect_unbiased(
      estimates(scene, kShot, {.mode = Mode::ambient, .spp = 16, .ambient_distance_m = 50}, 64,
                "occlusion"),
      [&](size_t i) -> std::optional<double> {
        const auto p = meet_plane(rays[i], {}, {0, 1, 0});
        if (!(normal.samples[3 * i + 1] > 0.5f)) return std::nullopt;
        return 1.0 - polygon_share(*p, {0, 1, 0}, half);
      });
}

// Emission seen from the floor through holes and by them.
TEST(Geometry, EmissionComesThroughHoles) {
  Scene scene = sheet_over_floor(false);
  scene.materials[0].base_color = glm::vec4(0, 0, 0, 1);
  scene.materials[1].base_color = glm::vec4(0, 0, 0, 1);
  add_quad(scene, {-40, 1.2f, 40}, {80, 0, 0}, {0, 0, -80}, add_diffuse(scene, 0, 1));
  const auto rays = rays_of(scene, kShot);
  const ImageF normal = layer(rendered(scene, kShot, kFew), "normal");
  const auto half = quad_corners({-0.5, static_cast<double>(0.6f), 0.5}, {0.5, 0, 0}, {0, 0, -1});
  const auto sky = quad_corners({-40, static_cast<double>(1.2f), 40}, {80, 0, 0}, {0, 0, -80});
  expect_unbiased(estimates(scene, kShot, {.spp = 16}, 64), [&](size_t i) -> std::optional<double> {
    const auto p = meet_plane(rays[i], {}, {0, 1, 0});
    if (!(normal.samples[3 * i + 1] > 0.5f)) return std::nullopt;
    return polygon_share(*p, {0, 1, 0}, sky) - polygon_share(*p, {0, 1, 0}, half);
  });
}

TEST(Geometry, NormalMapsTiltAlongTheTangents) {
  for (const float scale : {1.0f, 0.5f}) {
    Scene scene = square_scene();
    // Tangent +x, bitangent +y: (0.6, 0, 0.8) and (0, 0.6, 0.8), as near as eight bits come.
    for (const bool up : {false, true}) {
      const uint8_t tilt = 204, flat = 128, high = 230;
      scene.textures = {{.name = {},
                         .width = 1,
                         .height = 1,
                         .rgba = {up ? flat : tilt, up ? tilt : flat, high, 255}}};
      scene.materials[0].normal_texture = 0;
      scene.materials[0].normal_scale = scale;
      const Rendering r = rendered(scene, kShot, kFew);
      const auto unit = [](int v) { return 2.0 * v / 255 - 1; };
      const glm::dvec3 exact = glm::normalize(
          glm::dvec3(scale * unit(up ? flat : tilt), scale * unit(up ? tilt : flat), unit(high)));
      for (uint32_t c = 0; c < 3; ++c)
        EXPECT_NEAR(middle(layer(r, "normal"), c), exact[static_cast<int>(c)], 1e-5);
    }
  }
}

// A pixel that covers 2^k texels shows level k of the chain.
TEST(Geometry, TexturesAreFilteredForThePixel) {
  for (const uint32_t level : {0u, 1u, 2u, 3u}) {
    Scene scene = square_scene();
    Texture texture{.width = 64, .height = 64};
    for (uint32_t i = 0; i < 64 * 64; ++i) {
      const auto v = static_cast<uint8_t>((i * 2654435761u) >> 24);
      texture.rgba.insert(texture.rgba.end(), {v, static_cast<uint8_t>(255 - v), 77, 255});
    }
    scene.textures = {texture};
    scene.materials[0].base_color_texture = 0;
    // 16 pixels that see the square fill the view: 1 m at 2 m.
    scene.cameras[0].vertical_fov_rad = 2 * std::atan(0.25f);
    const uint32_t size = 64u >> level;
    const ImageF albedo = layer(rendered(scene, {size, size}, kFew), "albedo");
    const std::vector<MipLevel> chain = make_mip_chain(texture.rgba, 64, 64, true);
    const std::vector<uint8_t>& rgba = level == 0 ? texture.rgba : chain[level - 1].rgba;
    for (uint32_t y = 0; y < size; ++y)
      for (uint32_t x = 0; x < size; ++x)
        for (uint32_t c = 0; c < 3; ++c) {
          // v runs down the texture and, here, up the square. Look-ups are on texel centres up to a
          // rounding, of 1e-5 of a texel.
          const uint8_t code = rgba[4 * (size_t{size - 1 - y} * size + x) + c];
          EXPECT_NEAR(albedo.at(x, y, c), linear_from_srgb(static_cast<float>(code) / 255.0f),
                      1e-4f)
              << "level " << level << " at " << x << ", " << y;
        }
  }
}

TEST(Geometry, MetallicRoughnessTexturesMultiply) {
  Scene scene = square_scene();
  scene.textures = {{.name = {}, .width = 1, .height = 1, .rgba = {9, 51, 102, 255}}};
  Material& m = scene.materials[0];
  m.metallic_roughness_texture = 0;
  m.metallic = 0.5f;
  const Rendering r = rendered(scene, kShot, kFew);
  // Blue 102 / 255 = 0.4 of metallic 0.5: a fifth of the white is not diffuse.
  EXPECT_NEAR(middle(layer(r, "albedo")), 0.8f, 1e-5f);
}

// KHR_lights_punctual: ((cos - cos outer) / (cos inner - cos outer))^2 between the cones.
TEST(Geometry, SpotsFadeBetweenTheirCones) {
  Scene scene = square_scene();
  Light& light = add_light(scene, LightKind::spot, 6.0f, {0, 0, 1}, {0, 0, -1});
  light.inner_cone_rad = 0.15f;
  light.outer_cone_rad = 0.4f;
  const Rendering r = rendered(scene, kShot, kFew);
  int inside = 0, between = 0, outside = 0;
  for (const PixelRay& ray : rays_of(scene, kShot)) {
    const auto p = meet_plane(ray, {}, {0, 0, 1});
    if (std::abs(p->x) > 0.49 || std::abs(p->y) > 0.49) continue;
    const double distance = glm::length(*p - glm::dvec3(0, 0, 1)), cosine = 1 / distance;
    const double inner = std::cos(0.15), outer = std::cos(0.4);
    const double ramp = std::clamp((cosine - outer) / (inner - outer), 0.0, 1.0);
    const double exact = 6 * cosine / (distance * distance) * ramp * ramp / kPi;
    // cos inner - cos outer = 0.07, so the ramp has 15 times the roundings of a cosine.
    EXPECT_NEAR(layer(r, "source").at(ray.x, ray.y, 0), exact, 2e-5 * 6 / kPi);
    ++(ramp == 0 ? outside : ramp == 1 ? inside : between);
  }
  EXPECT_GT(inside, 4);
  EXPECT_GT(between, 20);
  EXPECT_GT(outside, 20);
}

// What the camera and the lights of a scene in motion see is that of the shot's time.
TEST(Geometry, ThePoseIsOfTheShotsTime) {
  Scene scene = square_scene();
  builtin::animate_translation(scene, scene.instances[0].node, 2,
                               [](float phase) { return glm::vec3(0, 0, -2 * phase); });
  Shot shot = kShot;
  EXPECT_FLOAT_EQ(middle(layer(rendered(scene, shot, kFew), "depth")), 2.0f);
  shot.time_s = 5;
  EXPECT_FLOAT_EQ(middle(layer(rendered(scene, shot, kFew), "depth")), 3.0f);
}

TEST(Geometry, NothingNearerThanTheNearPlane) {
  Scene scene = square_scene();
  scene.cameras[0].near_m = 2.5f;
  EXPECT_EQ(middle_depth(scene), 0.0f);
  add_quad(scene, {-5, -5, -1}, {10, 0, 0}, {0, 10, 0});
  EXPECT_FLOAT_EQ(middle_depth(scene), 3.0f);
}

// Shading normals that lean beyond the horizon: nothing is negative, not a number or brighter than
// what shines.
TEST(Geometry, LeaningNormalsStayFinite) {
  Scene scene = inside_box();
  scene.materials[0].specular = 1.0f;
  scene.materials[0].roughness = 0.3f;
  scene.materials[0].emission = glm::vec3(0.1f);
  for (size_t k = 0; k < scene.meshes[0].vertices.size(); ++k) {
    const auto a = static_cast<float>(k);
    scene.meshes[0].vertices[k].normal =
        glm::normalize(glm::vec3(std::sin(a), std::cos(3 * a), std::sin(7 * a)));
  }
  add_light(scene, LightKind::point, 1.0f, {0.5f, 0.5f, -0.5f});
  for (const Mode mode : {Mode::path, Mode::screen, Mode::screen_unoccluded, Mode::ambient})
    for (const ImageLayer& l :
         rendered(scene, kShot, {.mode = mode, .bounces = 4, .spp = 64}).layers)
      for (const float v : l.image.samples) {
        ASSERT_TRUE(std::isfinite(v)) << l.name;
        ASSERT_TRUE(v >= 0.0f || l.name == "normal") << l.name;
      }
}

TEST(Geometry, AnyScene) {
  // No triangles, no lights, a triangle without area, a mesh without primitives.
  Scene scene = scene_seen_from({0, 0, 2}, {0, 0, 0});
  for (const Mode mode : {Mode::path, Mode::screen, Mode::screen_unoccluded, Mode::ambient})
    EXPECT_TRUE(rendered(scene, {1, 1}, {.mode = mode, .spp = 8}).complete);
  add_quad(scene, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, add_diffuse(scene, 0, 1));
  for (Vertex& v : scene.meshes[0].vertices) v.position = {0.1f, 0.2f, 0.3f};
  scene.meshes.emplace_back();
  builtin::add_instance(scene, 1, scene.instances[0].node);
  for (const Mode mode : {Mode::path, Mode::screen, Mode::screen_unoccluded, Mode::ambient})
    for (const ImageLayer& l :
         rendered(scene, {37, 3}, {.mode = mode, .bounces = 2, .spp = 8}).layers)
      for (const float v : l.image.samples) ASSERT_EQ(v, 0.0f) << l.name;
}

}  // namespace
}  // namespace lueur::reference
