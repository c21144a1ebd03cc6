// SPDX-License-Identifier: MIT
#include "lights/light_views.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace lueur {
namespace {

constexpr Box kBox{{-4, -1, -3}, {5, 6, 2}};

// Views that have a point inside by more, or less, than their very edge.
int views_with(const std::vector<View>& views, const glm::vec3& point, float within) {
  int count = 0;
  for (const View& view : views) {
    const glm::vec4 clip = glm::make_mat4(view.clip_from_view.data()) *
                           glm::make_mat4(view.view_from_world.data()) * glm::vec4(point, 1);
    count += clip.w > 0 && clip.z <= clip.w && std::abs(clip.x) < within * clip.w &&
             std::abs(clip.y) < within * clip.w;
  }
  return count;
}

// Evenly over the sphere.
std::vector<glm::vec3> directions() {
  std::vector<glm::vec3> all;
  for (int i = 0; i < 2000; ++i) {
    const float z = 1 - (static_cast<float>(i) + 0.5f) / 1000, r = std::sqrt(1 - z * z);
    const float turn = 2.399963f * static_cast<float>(i);
    all.emplace_back(r * std::cos(turn), z, r * std::sin(turn));
  }
  return all;
}

void expect_no_mirror(const std::vector<View>& views) {
  for (const View& view : views)
    EXPECT_NEAR(glm::determinant(glm::mat3(glm::make_mat4(view.view_from_world.data()))), 1, 1e-5f);
}

TEST(LightViews, APointLightSeesEachDirectionOnce) {
  const PunctualLight light{.kind = PunctualLight::Kind::point, .position = {1, 2, 3}};
  const auto views = views_of_light(light, kBox);
  EXPECT_EQ(views.size(), 6u);
  expect_no_mirror(views);
  for (const glm::vec3& d : directions()) {
    const glm::vec3 point = glm::vec3(1, 2, 3) + 5.0f * d;
    EXPECT_GE(views_with(views, point, 1.0001f), 1);
    EXPECT_LE(views_with(views, point, 0.9999f), 1);
  }
}

TEST(LightViews, ASpotSeesItsConeWithNoFaceTooMany) {
  for (const float half_angle : {0.2f, 0.9f, 1.2f, 1.55f}) {
    const glm::vec3 axis = glm::normalize(glm::vec3(0.3f, -1, 0.2f));
    const PunctualLight light{.kind = PunctualLight::Kind::spot,
                              .position = {1, 2, 3},
                              .direction = {axis.x, axis.y, axis.z},
                              .outer_cone_rad = half_angle};
    const auto views = views_of_light(light, kBox);
    EXPECT_EQ(views.size(), half_angle < 1.0f ? 1u : 5u) << half_angle;
    expect_no_mirror(views);
    for (const glm::vec3& d : directions()) {
      if (glm::dot(d, axis) < std::cos(half_angle)) continue;
      EXPECT_GE(views_with(views, glm::vec3(1, 2, 3) + 5.0f * d, 1.0001f), 1);
    }
  }
}

TEST(LightViews, ASunSeesTheWholeBoxAlongItsRays) {
  const glm::vec3 axis = glm::normalize(glm::vec3(0.5f, -1, -0.4f));
  const PunctualLight light{.kind = PunctualLight::Kind::directional,
                            .direction = {axis.x, axis.y, axis.z}};
  const auto views = views_of_light(light, kBox);
  ASSERT_EQ(views.size(), 1u);
  expect_no_mirror(views);
  const glm::mat4 world_from_view = glm::inverse(glm::make_mat4(views[0].view_from_world.data()));
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 point(kBox.max[0] * float(corner & 1) + kBox.min[0] * float(!(corner & 1)),
                          corner & 2 ? kBox.max[1] : kBox.min[1],
                          corner & 4 ? kBox.max[2] : kBox.min[2]);
    EXPECT_EQ(views_with(views, point, 1.0f), 1);
    EXPECT_GT(glm::dot(glm::normalize(point - glm::vec3(world_from_view[3])), axis),
              std::cos(0.021f));
  }
}

}  // namespace
}  // namespace lueur
