// SPDX-License-Identifier: MIT
// Closed rooms whose light is known without looking: every way a path can go has the same end.
#include <cmath>
#include <numbers>

#include "reference/bsdf.h"
#include "reference/reference_fixture.h"
#include "scene/builtin/scene_builder.h"
#include "shading/brdf.h"

namespace lueur::reference {
namespace {

constexpr Shot kInside{16, 16};
constexpr int kInsideSeeds = 48;

// In a closed room of one albedo rho and emission e, n surfaces between light and receiver give
// E/pi = e (1 + rho + ... + rho^(n - 1)), whatever the room's shape.
double series(double emission, double albedo, uint32_t bounces) {
  double sum = 0;
  for (uint32_t n = 0; n < bounces; ++n) sum += emission * std::pow(albedo, n);
  return sum;
}

struct Furnace {
  const char* name;
  uint32_t bounces;
  bool box;
};
void PrintTo(const Furnace& furnace, std::ostream* out) {
  *out << furnace.name;
}

class FurnaceTest : public testing::TestWithParam<Furnace> {};
INSTANTIATE_TEST_SUITE_P(Rooms, FurnaceTest,
                         testing::Values(Furnace{"sphere_1", 1, false},
                                         Furnace{"sphere_2", 2, false},
                                         Furnace{"sphere_3", 3, false},
                                         Furnace{"sphere_8", 8, false}, Furnace{"box_1", 1, true},
                                         Furnace{"box_3", 3, true}, Furnace{"box_8", 8, true}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(FurnaceTest, BouncesAreAGeometricSeries) {
  const Furnace furnace = GetParam();
  Scene scene = furnace.box ? inside_box() : inside_sphere();
  scene.materials[0].base_color = glm::vec4(0.7f, 0.7f, 0.7f, 1.0f);
  scene.materials[0].emission = glm::vec3(2.0f);
  const Settings settings{.bounces = furnace.bounces, .spp = 16};
  const double exact = series(2.0, static_cast<double>(0.7f), furnace.bounces);
  expect_unbiased(estimates(scene, kInside, settings, kInsideSeeds), [&](size_t) { return exact; });
}

// Albedo rho, emission 1 - rho: radiance is 1 everywhere after infinitely many bounces, and
// 1 - rho^65 where the camera looks after 64.
Scene white_furnace(float albedo, Facets facets) {
  Scene scene = inside_sphere(facets);
  scene.materials[0].base_color = glm::vec4(glm::vec3(albedo), 1.0f);
  scene.materials[0].emission = glm::vec3(1.0f - albedo);
  return scene;
}
double mean_of(const Estimates& found) {
  double sum = 0;
  for (const double m : found.mean) sum += m;
  return sum / static_cast<double>(found.mean.size());
}
// Of the mean over all pixels, which are independent.
double error_of(const Estimates& found) {
  double squares = 0;
  for (const double e : found.error) squares += e * e;
  return std::sqrt(squares) / static_cast<double>(found.mean.size());
}

TEST(Furnace, WhiteRadianceIsOne) {
  for (const float albedo : {0.5f, 0.9f}) {
    const Settings settings{.bounces = kMaxBounces, .spp = 32};
    const Estimates found =
        estimates(white_furnace(albedo, Facets::flat), {12, 12}, settings, 32, "");
    const double exact = 1.0 - std::pow(static_cast<double>(albedo), kMaxBounces + 1);
    expect_unbiased(found, [&](size_t) { return exact; });
    // At albedo 0.9 paths are long and their sums scatter more.
    EXPECT_LT(error_of(found), albedo < 0.8f ? 2.5e-4 : 2e-3);  // four of them are 0.1 %
    EXPECT_NEAR(mean_of(found), exact, 4 * error_of(found)) << "albedo " << albedo;
    RecordProperty("mean_at_albedo_" + std::to_string(albedo), std::to_string(mean_of(found)));
  }
}

// Interpolated normals lean out of their triangles by up to half of pi / 16, and light from below a
// triangle is lost: never more than that, and nothing is gained. At the triangle's corner the share
// below, of a hemisphere that leans by a, is (1 - cos a) / 2 = 0.24 %, at each of the surfaces that
// the light comes by, 1 / (1 - rho) on the average.
TEST(Furnace, SmoothNormalsLoseWhatComesFromBelow) {
  const Estimates found = estimates(white_furnace(0.5f, Facets::smooth), {12, 12},
                                    {.bounces = kMaxBounces, .spp = 32}, 32, "");
  EXPECT_LT(mean_of(found), 1.0);
  EXPECT_GT(mean_of(found), 1.0 - 2 * 0.0024);
  RecordProperty("mean", std::to_string(mean_of(found)));
}

// In a black room that glows with radiance 1, a surface shows by `specular` the share of light that
// its lobe reflects, and by `diffuse` 1 whatever its material is.
struct Coat {
  const char* name;
  float metallic, roughness, specular;
  std::optional<PhongLobe> phong;
};
void PrintTo(const Coat& coat, std::ostream* out) {
  *out << coat.name;
}
class CoatTest : public testing::TestWithParam<Coat> {};
INSTANTIATE_TEST_SUITE_P(
    Lobes, CoatTest,
    testing::Values(Coat{"rough_metal", 1, 0.8f, 1, {}}, Coat{"glossy_metal", 1, 0.4f, 1, {}},
                    Coat{"dielectric", 0, 0.5f, 1, {}},
                    Coat{"phong", 0, 1, 1, PhongLobe{glm::vec3(0.4f), 12}},
                    Coat{"lafortune", 0, 1, 1, PhongLobe{glm::vec3(0.4f), 6, -1.0f, 0.5f}}),
    [](const auto& test) { return std::string(test.param.name); });

TEST_P(CoatTest, ReflectsTheShareOfItsLobe) {
  const Coat coat = GetParam();
  Scene scene = inside_box();
  scene.materials[0].base_color = glm::vec4(0, 0, 0, 1);
  scene.materials[0].emission = glm::vec3(1.0f);
  builtin::add_material(scene, "coat", glm::vec3(0.6f), coat.roughness);
  Material& material = scene.materials.back();
  material.metallic = coat.metallic;
  material.specular = coat.specular;
  material.phong = coat.phong;
  const Shot shot{12, 12};
  add_quad(scene, {-0.9f, -0.9f, 0.9f}, {1.8f, 0, 0}, {0, 0, -1.8f}, 1);
  scene.nodes[0].translation = {0.5f, 0.3f, 0.5f};
  scene.nodes[0].rotation = builtin::look_along({-0.6f, -0.9f, -0.7f});

  const auto [diffuse, specular] =
      estimates_of_both(scene, shot, {.spp = 32}, kInsideSeeds, "indirect", "indirect_specular");
  const auto to_eye = [&](const PixelRay& ray) -> std::optional<glm::vec3> {
    const auto p = meet_plane(ray, {0, -0.9, 0}, {0, 1, 0});
    if (!p || std::abs(p->x) > 0.89 || std::abs(p->z) > 0.89) return std::nullopt;
    return glm::vec3(-glm::normalize(ray.direction));
  };
  const std::vector<PixelRay> rays = rays_of(scene, shot);
  static const Rule kRule = gauss_legendre(96);
  expect_unbiased(diffuse, [&](size_t i) -> std::optional<double> {
    if (!to_eye(rays[i])) return std::nullopt;
    return 1.0;
  });
  expect_unbiased(specular, [&](size_t i) -> std::optional<double> {
    const auto eye = to_eye(rays[i]);
    if (!eye) return std::nullopt;
    const Bsdf bsdf({.normal = {0, 1, 0},
                     .to_eye = *eye,
                     .specular_f0 = specular_f0(glm::vec3(0.6f), coat.metallic, coat.specular),
                     .specular_f90 = specular_f90(coat.metallic, coat.specular),
                     .roughness = coat.roughness,
                     .phong = coat.phong},
                    0.0f);
    double sum = 0;
    for (size_t a = 0; a < kRule.at.size(); ++a)
      for (size_t b = 0; b < kRule.at.size(); ++b) {
        const double theta = 0.5 * std::numbers::pi * kRule.at[a];
        const double phi = 2 * std::numbers::pi * kRule.at[b];
        const glm::vec3 l(std::sin(theta) * std::cos(phi), std::cos(theta),
                          std::sin(theta) * std::sin(phi));
        sum += kRule.weight[a] * kRule.weight[b] * std::sin(theta) *
               static_cast<double>(bsdf.specular(l).r * bsdf.cosine(l));
      }
    return sum * std::numbers::pi * std::numbers::pi;
  });
}

// The picture is put together of its layers.
TEST(Furnace, ThePictureIsTheSumOfItsLayers) {
  Scene scene = inside_box();
  scene.materials[0].base_color = glm::vec4(0.3f, 0.6f, 0.9f, 1.0f);
  scene.materials[0].specular = 1.0f;
  scene.materials[0].roughness = 0.5f;
  scene.materials[0].emission = glm::vec3(0.1f, 0.2f, 0.3f);
  add_light(scene, LightKind::point, 3.0f, {0.2f, 0.7f, 0.1f});
  const Rendering r = rendered(scene, kInside, {.spp = 8});
  const ImageF &picture = layer(r, ""), &direct = layer(r, "direct"), &source = layer(r, "source"),
               &specular = layer(r, "specular"), &albedo = layer(r, "albedo"),
               &indirect = layer(r, "indirect"), &glossy = layer(r, "indirect_specular");
  ASSERT_FALSE(HasFailure());
  for (size_t k = 0; k < picture.samples.size(); ++k) {
    const float d = source.samples[k] + specular.samples[k];
    EXPECT_FLOAT_EQ(direct.samples[k], d);
    EXPECT_FLOAT_EQ(picture.samples[k],
                    d + albedo.samples[k] * indirect.samples[k] + glossy.samples[k]);
  }
}

}  // namespace
}  // namespace lueur::reference
