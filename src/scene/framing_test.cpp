// SPDX-License-Identifier: MIT
#include "scene/framing.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <string>

namespace lueur {
namespace {

using glm::vec3;

// A box of quads from -size/2 to size/2 that face inwards or outwards; `skipped` (0 to 5: -x, +x,
// -y, +y, -z, +z) is left out.
Scene box_scene(const vec3& size, bool inwards, int skipped = -1) {
  Mesh mesh;
  for (int side = 0; side < 6; ++side) {
    if (side == skipped) continue;
    const int axis = side / 2;
    vec3 outwards(0.0f);
    outwards[axis] = side % 2 == 0 ? -1.0f : 1.0f;
    vec3 u(0.0f);
    u[(axis + 1) % 3] = 1.0f;
    const vec3 v = glm::cross(outwards, u);
    const uint32_t first = static_cast<uint32_t>(mesh.vertices.size());
    for (const glm::vec2 corner :
         {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
      const vec3 p = 0.5f * size * (outwards + u * corner.x + v * corner.y);
      mesh.vertices.push_back({p, inwards ? -outwards : outwards, {u, 1.0f}, corner});
    }
    for (const uint32_t index : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + index);
  }
  if (inwards)
    for (size_t i = 0; i < mesh.indices.size(); i += 3)
      std::swap(mesh.indices[i], mesh.indices[i + 1]);
  mesh.primitives = {{0, static_cast<uint32_t>(mesh.indices.size()), 0}};
  Scene scene;
  scene.meshes = {mesh};
  scene.materials.resize(1);
  scene.nodes.resize(1);
  scene.instances = {{0, 0}};
  return scene;
}

glm::mat4 world_of(const Scene& scene, int32_t node) {
  return pose(scene, 0.0f)[static_cast<size_t>(node)];
}

TEST(Framing, ObjectsFitTheViewWithAMargin) {
  for (const vec3 size : {vec3(1, 1, 1), vec3(10, 0.5f, 1), vec3(0.01f, 0.03f, 0.01f)}) {
    Scene scene = box_scene(size, false);
    complete(scene);
    ASSERT_EQ(scene.cameras.size(), 1u);
    const glm::mat4 view = glm::inverse(world_of(scene, scene.cameras[0].node));
    const float tangent = std::tan(scene.cameras[0].vertical_fov_rad * 0.5f);
    float widest = 0.0f;
    for (const Vertex& vertex : scene.meshes[0].vertices) {
      const vec3 p(view * glm::vec4(vertex.position, 1.0f));
      ASSERT_LT(p.z, -scene.cameras[0].near_m);
      widest = std::max({widest, std::abs(p.y) / (-p.z * tangent),
                         std::abs(p.x) / (-p.z * tangent * 4.0f / 3.0f)});
    }
    // Exactly one corner reaches the margin of 5 %.
    EXPECT_NEAR(widest, 1.0f / 1.05f, 1e-3f);
  }
}

TEST(Framing, ObjectsGetASunFromAbove) {
  Scene scene = box_scene(vec3(1.0f), false);
  complete(scene);
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.lights[0].kind, LightKind::directional);
  EXPECT_FLOAT_EQ(scene.lights[0].intensity, glm::pi<float>());
  const glm::mat4 camera = world_of(scene, scene.cameras[0].node);
  const vec3 to_sun(world_of(scene, scene.lights[0].node)[2]);
  EXPECT_GT(to_sun.y, 0.5f);
  EXPECT_LT(glm::dot(to_sun, vec3(camera[0])), 0.0f) << "from the left";
  EXPECT_GT(glm::dot(to_sun, vec3(camera[2])), 0.0f) << "from the camera's side";
  ASSERT_EQ(scene.warnings.size(), 2u);
  EXPECT_NE(scene.warnings[0].find("no camera in the file"), std::string::npos);
  EXPECT_NE(scene.warnings[1].find("no light in the file"), std::string::npos);
}

TEST(Framing, ClosedRoomsAreSeenFromInsideByALamp) {
  const vec3 size(12.0f, 3.0f, 5.0f);
  Scene scene = box_scene(size, true);
  complete(scene);
  const glm::mat4 camera = world_of(scene, scene.cameras[0].node);
  for (int i = 0; i < 3; ++i) EXPECT_LT(std::abs(camera[3][i]), size[i] * 0.5f);
  EXPECT_GT(std::abs(camera[2].x), 0.9f) << "along the room";
  EXPECT_GT(camera[2].x * camera[3].x, 3.0f) << "from one end towards the other";
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.lights[0].kind, LightKind::point);
  // The floor right below it gets pi lux.
  const vec3 lamp(world_of(scene, scene.lights[0].node)[3]);
  const float height = lamp.y + size.y * 0.5f;
  EXPECT_NEAR(scene.lights[0].intensity / (height * height), glm::pi<float>(), 1e-3f);
  EXPECT_LT(lamp.y, size.y * 0.5f);
  EXPECT_LT(std::hypot(lamp.x, lamp.z), 1.0f) << "over the middle";
}

TEST(Framing, TheSunReachesTheFloorOfACourtyard) {
  const vec3 size(12.0f, 6.0f, 8.0f);
  Scene scene = box_scene(size, true, 3);
  complete(scene);
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.lights[0].kind, LightKind::directional);
  const vec3 to_sun(world_of(scene, scene.lights[0].node)[2]);
  EXPECT_NEAR(scene.lights[0].intensity * to_sun.y, glm::pi<float>(), 1e-4f);
  // Walls shade less than the whole floor: the sun is above the diagonal.
  EXPECT_LT(size.y / to_sun.y * std::abs(to_sun.x), size.x);
  EXPECT_LT(size.y / to_sun.y * std::abs(to_sun.z), size.z);
}

TEST(Framing, OpenBoxesAreSeenThroughTheMissingWall) {
  Scene scene = box_scene(vec3(550.0f), true, 5);
  complete(scene);
  const glm::mat4 camera = world_of(scene, scene.cameras[0].node);
  EXPECT_GT(camera[3].z, 275.0f);
  EXPECT_NEAR(camera[2].z, 1.0f, 1e-5f);
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.lights[0].kind, LightKind::point);
}

TEST(Framing, ScenesThatAreCompleteStayAsTheyAre) {
  Scene scene = box_scene(vec3(1.0f), false);
  scene.cameras.push_back({});
  scene.lights.push_back({});
  complete(scene);
  EXPECT_EQ(scene.cameras.size(), 1u);
  EXPECT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.nodes.size(), 1u);
  EXPECT_TRUE(scene.warnings.empty());
}

TEST(Framing, WhatShinesOnItsOwnNeedsNoLight) {
  Scene around = box_scene(vec3(1.0f), false);
  around.environment.emplace();
  complete(around);
  EXPECT_TRUE(around.lights.empty());
  EXPECT_NE(around.warnings.back().find("environment"), std::string::npos);
  // Of the box's six sides all glow, so the share is the luminance over 1 cd/m2: 2 % are enough.
  for (const float emission : {0.019f, 0.021f}) {
    Scene scene = box_scene(vec3(1.0f), false);
    scene.materials[0].emission = vec3(emission);
    complete(scene);
    EXPECT_EQ(scene.lights.size(), emission < 0.02f ? 1u : 0u);
    EXPECT_EQ(scene.warnings.back().find("glow") == std::string::npos, emission < 0.02f);
  }
  // A texture of which one pixel in four glows.
  for (const float emission : {0.076f, 0.084f}) {
    Scene scene = box_scene(vec3(1.0f), false);
    scene.materials[0].emission = vec3(emission);
    scene.materials[0].emission_texture = 0;
    std::vector<uint8_t> texels(16, 0);
    std::fill_n(texels.begin(), 4, uint8_t{255});
    scene.textures.push_back({.width = 2, .height = 2, .rgba = std::move(texels)});
    complete(scene);
    EXPECT_EQ(scene.lights.size(), emission < 0.08f ? 1u : 0u);
  }
}

TEST(Framing, EmptyScenesGetBothToo) {
  Scene scene;
  scene.materials.resize(1);
  complete(scene);
  EXPECT_EQ(scene.cameras.size(), 1u);
  EXPECT_EQ(scene.lights.size(), 1u);
  for (const glm::mat4& world : pose(scene, 0.0f))
    for (int i = 0; i < 4; ++i)
      EXPECT_TRUE(std::isfinite(world[3][i]) && std::isfinite(world[2][i]));
}

}  // namespace
}  // namespace lueur
