// SPDX-License-Identifier: MIT
// What lies behind all surfaces, as techniques see it in views of their own.
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <numbers>

#include "lights/light_views.h"
#include "renderer/asking_technique.h"
#include "renderer/renderer_fixture.h"

namespace lueur {
namespace {

constexpr uint32_t kWidth = 256, kHeight = 128;

// Red, green and blue tell three directions apart, smoothly: where +x, +y and +z of the picture's
// own space are. Radiance that a unit direction has, without the intensity.
glm::dvec3 radiance_along(const glm::dvec3& unit) {
  return 2.0 + 1.5 * unit;
}

Environment picture() {
  Environment environment{.width = kWidth, .height = kHeight};
  for (uint32_t row = 0; row < kHeight; ++row)
    for (uint32_t column = 0; column < kWidth; ++column) {
      // As environment.h says it: the middle column looks along -z, +x is in the right half.
      const double around = ((column + 0.5) / kWidth - 0.5) * 2 * std::numbers::pi;
      const double up = (0.5 - (row + 0.5) / kHeight) * std::numbers::pi;
      const glm::dvec3 radiance = radiance_along(
          {std::cos(up) * std::sin(around), std::sin(up), -std::cos(up) * std::cos(around)});
      for (int c = 0; c < 3; ++c) environment.rgb.push_back(static_cast<float>(radiance[c]));
    }
  return environment;
}

// The direction through a point of the image, from the view's matrices alone: what they take to the
// pixel, and so without any of the pass' own steps.
glm::dvec3 direction_through(const View& view, Extent extent, double x, double y) {
  const glm::dmat4 clip_from_world(glm::make_mat4(view.clip_from_view.data()) *
                                   glm::make_mat4(view.view_from_world.data()));
  const glm::dmat4 world_from_clip = glm::inverse(clip_from_world);
  const glm::dvec2 ndc(2 * x / extent.width - 1, 2 * y / extent.height - 1);
  // Points at two depths.
  const glm::dvec4 near = world_from_clip * glm::dvec4(ndc, 1.0, 1.0);
  const glm::dvec4 far = world_from_clip * glm::dvec4(ndc, 0.5, 1.0);
  return glm::normalize(glm::dvec3(far) / far.w - glm::dvec3(near) / near.w);
}

class SceneHostBackgroundTest : public RendererTest {
 protected:
  struct Asked {
    View view;
    Extent extent;
  };
  // Holds what the host gives of each view against the environment's own radiance.
  void expect_environment(Scene scene, const std::vector<Asked>& views) {
    scene.environment = picture();
    scene.environment->rotation_rad = 0.7f;
    scene.environment->intensity = 3.0f;
    AskingTechnique technique([&](Frame& frame, const Inputs& inputs) {
      for (size_t i = 0; i < views.size(); ++i) {
        const Image image = inputs.host->background(frame, views[i].view, views[i].extent);
        EXPECT_EQ(image.extent, views[i].extent);
        EXPECT_EQ(image.format, Format::rgba16f);
        frame.recorder().read_back("view" + std::to_string(i), image);
      }
    });
    render(scene, {.extent = kExtent}, &technique);
    const glm::dmat3 own_from_world(environment_from_world(*scene.environment));
    for (size_t i = 0; i < views.size(); ++i) {
      const Extent extent = views[i].extent;
      const Pixels found = pixels("view" + std::to_string(i));
      for (uint32_t y = 0; y < extent.height; ++y)
        for (uint32_t x = 0; x < extent.width; ++x) {
          const glm::dvec3 direction = direction_through(views[i].view, extent, x + 0.5, y + 0.5);
          const glm::dvec3 want = 3.0 * radiance_along(own_from_world * direction);
          for (uint32_t c = 0; c < 3; ++c) {
            const double radiance = want[static_cast<int>(c)];
            // Two roundings to half floats; weights of 8 bits between neighbours, of a slope of
            // 3 x 1.5 a radian; curvature between them, and one level's mean.
            ASSERT_NEAR(static_cast<double>(found.samples[4 * (y * extent.width + x) + c]),
                        radiance, radiance / 1024 + kSlope * (kSide_rad / 256 + kCurvature))
                << "view " << i << " at " << x << ", " << y << " channel " << c;
          }
        }
    }
  }
  static constexpr double kSlope = 3 * 1.5;
  // At a level of side s, the mean over a pixel and the way between neighbours each depart by at
  // most s^2 / 8 from a function whose second derivative is 1; coordinates near the poles by more.
  static constexpr double kSide_rad = 4 * std::numbers::pi / kHeight;
  static constexpr double kCurvature = kSide_rad * kSide_rad / 2;
};

TEST_F(SceneHostBackgroundTest, AllSixFacesOfACube) {
  const PunctualLight light{.position = {1, -2, 3}};
  std::vector<Asked> faces;
  for (const View& face : views_of_light(light, {})) faces.push_back({face, {24, 24}});
  ASSERT_EQ(faces.size(), 6u);
  Scene scene = scene_seen_from({0, 0, 3}, {0, 0, 0});
  // Nothing is in the way, not even what surrounds the views.
  add_quad(scene, {-50, -50, 0}, {100, 0, 0}, {0, 100, 0});
  expect_environment(scene, faces);
}

TEST_F(SceneHostBackgroundTest, ViewsMayBeFlatNarrowAndOffCentre) {
  const auto window = [](float left, float right, float bottom, float top) {
    glm::mat4 clip(0.0f);
    clip[0][0] = 2 / (right - left);
    clip[2][0] = (right + left) / (right - left);
    clip[1][1] = -2 / (top - bottom);
    clip[2][1] = -(top + bottom) / (top - bottom);
    clip[2][3] = -1;
    clip[3][2] = 0.1f;
    return clip;
  };
  const Scene scene = scene_seen_from({1, 2, 3}, {0.5f, 0.2f, 4});
  std::vector<Asked> views;
  for (const auto& [clip, extent] : {std::pair{window(-0.2f, 1.5f, 0.1f, 0.6f), Extent{40, 12}},
                                     {window(-1.5f, -1.0f, -2, 1), Extent{8, 60}}}) {
    Asked& asked = views.emplace_back(view_of(scene, {.extent = extent}), extent);
    std::copy_n(glm::value_ptr(clip), 16, asked.view.clip_from_view.begin());
  }
  expect_environment(scene, views);
}

TEST_F(SceneHostBackgroundTest, IsWhatThePictureShowsBehindItsSurfaces) {
  Scene scene = scene_seen_from({0, 0, 3}, {0, 0, 0});
  add_quad(scene, {-0.5f, -0.5f, 0}, {1, 0, 0}, {0, 1, 0});
  scene.environment = picture();
  AskingTechnique technique([&](Frame& frame, const Inputs& inputs) {
    frame.recorder().read_back("alone", inputs.host->background(frame, inputs.view, kExtent));
  });
  render(scene, {.extent = kExtent}, &technique);
  size_t behind = 0;
  for (const PixelRay& ray : rays()) {
    EXPECT_GT(at("alone", ray).y, 0.4f);
    if (at("depth", ray).x > 0.0f) continue;
    ++behind;
    ASSERT_EQ(at("alone", ray), at("composed", ray));
  }
  EXPECT_GT(behind, 1000u);
  EXPECT_LT(behind, rays().size() - 100);
}

TEST_F(SceneHostBackgroundTest, IsInvalidWithoutAnEnvironment) {
  Scene scene = scene_seen_from({0, 0, 3}, {0, 0, 0});
  AskingTechnique technique([&](Frame& frame, const Inputs& inputs) {
    EXPECT_FALSE(inputs.host->background(frame, inputs.view, kExtent).valid());
  });
  render(scene, {.extent = kExtent}, &technique);
}

}  // namespace
}  // namespace lueur
