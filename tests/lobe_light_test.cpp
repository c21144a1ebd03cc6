// SPDX-License-Identifier: MIT
// Light through Phong's and Lafortune's lobes against the reference's: the rasterizer's direct
// light, and the technique's glossy light by the renderer's G-buffer and table.
#include <algorithm>
#include <array>
#include <cmath>

#include "lueur/hierarchical.h"
#include "reference/reference.h"
#include "renderer/renderer.h"
#include "scene/builtin/scene_builder.h"
#include "support/gpu_test.h"
#include "support/test_scene.h"

namespace lueur {
namespace {

constexpr Extent kLobeExtent{320, 120};

struct LobeCase {
  const char* name;
  PhongLobe lobe;
};

// Whoever takes a neighbour's lobe has another colour, too.
const std::array kLobes{
    LobeCase{"Phong", {{0.9f, 0.3f, 0.2f}, 6}},
    LobeCase{"narrow Phong", {{0.2f, 0.7f, 0.3f}, 80}},
    LobeCase{"Lafortune, off-specular", {{0.3f, 0.4f, 0.9f}, 4, -1, 0.55f}},
    LobeCase{"Lafortune, steeper than a mirror", {{0.8f, 0.7f, 0.1f}, 9, -0.4f, 1}},
    LobeCase{"Lafortune, back to the light", {{0.6f, 0.2f, 0.6f}, 6, 1, 0.9f}},
    LobeCase{"coefficients of 0", {{1, 1, 1}, 0, 0, 0}},
};
constexpr glm::vec3 kEye{0, 0.3f, 4.2f};

// A panel of 0.7 x 1.9 m; `normal` is that of its plane.
struct Panel {
  glm::vec3 centre{0.0f};
  glm::vec3 normal{0, 0, 1};

  glm::vec3 right() const { return glm::normalize(glm::cross(glm::vec3(0, 1, 0), normal)); }
  glm::vec3 up() const { return glm::cross(normal, right()); }
};
using Panels = std::array<Panel, kLobes.size()>;

// Side by side, so that nothing shades anything.
template <class Normal>
Panels panels(Normal normal_at) {
  Panels list;
  for (size_t i = 0; i < list.size(); ++i) {
    list[i].centre = {static_cast<float>(i) - 2.5f, 0, 0};
    list[i].normal = normal_at(list[i].centre);
  }
  return list;
}

// What is off the middle between eye and light by an angle about the vertical.
Panels panels_that_mirror(const glm::vec3& light, float off_rad) {
  return panels([&](const glm::vec3& centre) {
    return glm::angleAxis(off_rad, glm::vec3(0, 1, 0)) *
           glm::normalize(glm::normalize(kEye - centre) + glm::normalize(light - centre));
  });
}

Scene scene_of(const Panels& panels) {
  Scene scene = scene_seen_from(kEye, {0, 0, 0});
  scene.cameras[0].vertical_fov_rad = 0.55f;
  for (size_t i = 0; i < panels.size(); ++i) {
    const int32_t material = builtin::add_material(scene, kLobes[i].name, glm::vec3(0.3f), 0.3f);
    scene.materials.back().phong = kLobes[i].lobe;
    const glm::vec3 u = 0.7f * panels[i].right(), v = 1.9f * panels[i].up();
    add_quad(scene, panels[i].centre - 0.5f * (u + v), u, v, material);
  }
  return scene;
}

class LobeLightTest : public GpuTest {
 protected:
  // Holds `specular` of both together, pixel by pixel. `irradiance` is what the lights together
  // give at most; `normals_turn_rad` what normals turn by from pixel to pixel. Adds up how many
  // samples of each panel are worth a look.
  void compare(const Scene& scene, const Panels& panels, double irradiance,
               double normals_turn_rad = 0) {
    auto renderer = Renderer::create(system(), context(), scene);
    ASSERT_TRUE(renderer.ok());
    EXPECT_TRUE((*renderer)->warnings().empty());
    run([&](Frame& frame) {
      const RenderedImages images = (*renderer)->record(frame, {.extent = kLobeExtent}, nullptr);
      frame.recorder().read_back("specular", images.specular);
    });
    const auto truth = reference::render(
        scene, {.width = kLobeExtent.width, .height = kLobeExtent.height}, {.spp = 1});
    ASSERT_TRUE(truth.ok());
    const ImageF& want = *find_layer(*truth, "specular");
    const Pixels seen = pixels("specular");
    const glm::dmat4 world_from_camera(pose(scene, 0)[static_cast<size_t>(scene.cameras[0].node)]);
    const auto rays =
        pixel_rays(scene.cameras[0], world_from_camera, kLobeExtent.width, kLobeExtent.height);
    for (size_t i = 0; i < panels.size(); ++i) {
      const PhongLobe& lobe = kLobes[i].lobe;
      // Sums in half floats, two at most. Normals lie within 2^-15 sqrt(2) of where they should,
      // and where a rasterizer's 256th of a pixel puts them; that turns the mirrored eye by twice
      // as much. By a radian a lobe above 1e-3 of its peak changes
      // n tan(acos(1e-3^(1/n))) < sqrt(14 n) + 14 times.
      const double n = lobe.exponent;
      const double turned = 2 * (std::sqrt(2.0) / 32768 + normals_turn_rad / 256);
      const double tolerance = 2.0 / 2048 + turned * (std::sqrt(14 * n) + 14);
      const double dim = 1e-3 * (n + 2) / 6.28 * irradiance;
      double worst = 0;
      for (const PixelRay& ray : rays) {
        const auto p = meet_plane(ray, panels[i].centre, panels[i].normal);
        if (!p) continue;
        const glm::dvec3 from_centre = *p - glm::dvec3(panels[i].centre);
        // At an edge a pixel's ray may meet the panel or not.
        if (std::abs(glm::dot(from_centre, glm::dvec3(panels[i].right()))) > 0.34) continue;
        if (std::abs(glm::dot(from_centre, glm::dvec3(panels[i].up()))) > 0.94) continue;
        for (uint32_t c = 0; c < 3; ++c) {
          const double exact = want.at(ray.x, ray.y, c);
          const double ours = seen.samples[ray.index * seen.channels + c];
          ASSERT_NEAR(ours, exact, tolerance * (exact + dim))
              << kLobes[i].name << " at " << ray.x << ", " << ray.y << ", channel " << c;
          worst = std::max(worst, std::abs(ours - exact) / (exact + dim) / tolerance);
          bright_[i] += exact > 20 * dim * lobe.color[static_cast<int>(c)] ? 1 : 0;
        }
      }
      std::printf("%s: the worst sample is at %.2f of the tolerance of %.2f %%\n", kLobes[i].name,
                  worst, 100 * tolerance);
    }
  }

  std::array<size_t, kLobes.size()> bright_{};
  // Of all but the last, which reflects nothing.
  void expect_bright(size_t least) {
    for (size_t i = 0; i + 1 < kLobes.size(); ++i) EXPECT_GT(bright_[i], least) << kLobes[i].name;
    EXPECT_EQ(bright_.back(), 0u);
  }
};

constexpr float kOffRad[] = {-0.25f, 0.0f, 0.3f};

TEST_F(LobeLightTest, OfAPointLight) {
  constexpr glm::vec3 kLight{0.9f, 0.8f, 3.0f};
  for (const float off_rad : kOffRad) {
    const Panels panels = panels_that_mirror(kLight, off_rad);
    Scene scene = scene_of(panels);
    add_light(scene, LightKind::point, 30.0f, kLight);
    compare(scene, panels, 30.0 / 9);
  }
  expect_bright(2000);
}

TEST_F(LobeLightTest, OfADirectionalLight) {
  constexpr glm::vec3 kToLight{0.5f, 0.2f, 1};
  for (const float off_rad : kOffRad) {
    const Panels panels = panels_that_mirror(1e5f * kToLight, off_rad);
    Scene scene = scene_of(panels);
    add_light(scene, LightKind::directional, 5.0f, {}, -kToLight);
    compare(scene, panels, 5);
  }
  expect_bright(2000);
}

TEST_F(LobeLightTest, OfBothTogether) {
  constexpr glm::vec3 kLight{0.9f, 0.8f, 3.0f};
  const Panels panels = panels_that_mirror(kLight, 0.1f);
  Scene scene = scene_of(panels);
  add_light(scene, LightKind::point, 30.0f, kLight);
  add_light(scene, LightKind::directional, 5.0f, {}, {-0.5f, -0.2f, -1});
  compare(scene, panels, 30.0 / 9 + 5);
  expect_bright(1000);
}

// Normals that turn from the eye: it sees such surfaces along themselves.
TEST_F(LobeLightTest, OfNormalsTurnedFromTheEye) {
  const Panels panels = ::lueur::panels([](const glm::vec3&) { return glm::vec3(0, 0, 1); });
  Scene scene = scene_of(panels);
  for (size_t i = 0; i < panels.size(); ++i) {
    const glm::vec3 to_eye = glm::normalize(kEye - panels[i].centre);
    const float side = panels[i].centre.x < 0 ? -1.0f : 1.0f;
    for (Vertex& vertex : scene.meshes[i].vertices) {
      // From 0.2 rad before the eye's horizon to as much behind it.
      const glm::quat turn =
          glm::angleAxis(side * (1.3708f + 0.4f * vertex.uv.y), glm::vec3(0, 1, 0));
      vertex.normal = glm::normalize(turn * to_eye);
    }
  }
  add_light(scene, LightKind::directional, 5.0f, {}, {0, 0, -1});
  compare(scene, panels, 5, 0.4 / 40);
  // Others hardly reflect light from there.
  EXPECT_GT(bright_[4], 500u);
}

// A black floor with a lobe before a wall that glows in three colours, all of which the camera
// sees.
Scene floor_before_wall(const PhongLobe& lobe) {
  Scene scene = scene_seen_from({0, 1.0f, 2.2f}, {0, 0.35f, -1});
  const int32_t floor = builtin::add_material(scene, "floor", glm::vec3(0));
  scene.materials.back().phong = lobe;
  add_quad(scene, {-1.2f, 0, 1}, {2.4f, 0, 0}, {0, 0, -2}, floor);
  for (int i = 0; i < 3; ++i) {
    const int32_t lamp = builtin::add_material(scene, "lamp", glm::vec3(0));
    scene.materials.back().specular = 0;
    scene.materials.back().emission = glm::vec3(i == 0, i == 1, i == 2) + 0.1f;
    add_quad(scene, {0.8f * static_cast<float>(i) - 1.2f, 0, -1}, {0.8f, 0, 0}, {0, 1, 0}, lamp);
  }
  return scene;
}

// Glossy light of the technique against the path tracer's: it takes the renderer's G-buffer and its
// table of lobes.
TEST_F(LobeLightTest, OfGlowingSurfacesByTheTechnique) {
  constexpr Extent kSmall{80, 60};
  constexpr uint32_t kFrames = 8;
  for (const PhongLobe& lobe :
       {PhongLobe{{0.9f, 0.6f, 0.3f}, 5}, PhongLobe{{0.9f, 0.6f, 0.3f}, 5, -1, 0.4f}}) {
    const Scene scene = floor_before_wall(lobe);
    auto renderer = Renderer::create(system(), context(), scene);
    ASSERT_TRUE(renderer.ok());
    Hierarchical technique({.start = HierarchicalSettings::Start::full,
                            .radius = 60,
                            .filter = false,
                            .glossy = true,
                            .glossy_samples = 256,
                            .temporal = 0});
    std::vector<double> mean(size_t{kSmall.width} * kSmall.height * 3, 0.0);
    for (uint32_t seed = 0; seed < kFrames; ++seed) {
      run([&](Frame& frame) {
        const RenderedImages images =
            (*renderer)->record(frame, {.extent = kSmall, .seed = seed}, &technique);
        frame.recorder().read_back("specular", images.indirect_specular);
      });
      const Pixels seen = pixels("specular");
      for (size_t i = 0; i < mean.size(); ++i)
        mean[i] += static_cast<double>(seen.samples[i / 3 * seen.channels + i % 3]) / kFrames;
    }
    const auto truth = reference::render(scene, {.width = kSmall.width, .height = kSmall.height},
                                         {.bounces = 1, .spp = 256});
    ASSERT_TRUE(truth.ok());
    const ImageF& want = *find_layer(*truth, "indirect_specular");
    double error = 0, power = 0, ours = 0, sum = 0;
    const glm::dmat4 world_from_camera(pose(scene, 0)[static_cast<size_t>(scene.cameras[0].node)]);
    const auto rays = pixel_rays(scene.cameras[0], world_from_camera, kSmall.width, kSmall.height);
    for (size_t i = 0; i < mean.size(); ++i) {
      const auto p = meet_plane(rays[i / 3], {}, {0, 1, 0});
      // Close to the wall a sample's patch is large against its distance.
      if (!p || std::abs(p->x) > 1.2 || p->z < -0.3) continue;
      const double exact = want.samples[i];
      error += (mean[i] - exact) * (mean[i] - exact);
      power += exact * exact;
      ours += mean[i];
      sum += exact;
    }
    std::printf("c_z %.1f: %.1f %% root mean square error, %+.1f %% in all\n",
                static_cast<double>(lobe.c_z), 100 * std::sqrt(error / power),
                100 * (ours / sum - 1));
    // The technique widens lobes to the patches that samples stand for, 7 x 7 pixels, and the mean
    // of so few frames is noisy. A lobe of another shape is off by half and more.
    EXPECT_LT(std::sqrt(error / power), 0.1);
  }
}

}  // namespace
}  // namespace lueur
