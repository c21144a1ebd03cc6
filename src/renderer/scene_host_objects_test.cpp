// SPDX-License-Identifier: MIT
// Which objects move, in which pixels they are, and what a view shows without them.
#include <algorithm>
#include <glm/gtc/type_ptr.hpp>

#include "renderer/asking_technique.h"
#include "renderer/renderer_fixture.h"
#include "scene/builtin/scene_builder.h"

namespace lueur {
namespace {

// Objects by name in the order of their first instances; see stage().
constexpr uint32_t kLeft = 0, kRight = 1, kSkinned = 2, kHalves = 3;
constexpr uint32_t kObjects = 4;

class SceneHostObjectsTest : public RendererTest {
 protected:
  // Four squares of one metre in a row, at x from -2 to 2 and z = 0, in front of a wall at z = -2.
  // The first three are of one mesh, and so is a smaller one that stands still in the middle of
  // them, so that draws of several instances have to be taken apart: left, still, right. The third
  // is skinned, the fourth is two instances below one node.
  static Scene stage() {
    Scene scene = scene_seen_from({0, 0, 5}, {0, 0, 0});
    add_quad(scene, {-8, -8, -2}, {16, 0, 0}, {0, 16, 0});
    const int32_t red = builtin::add_material(scene, "red", {0.8f, 0.1f, 0.1f}, 1.0f);
    const int32_t left = add_quad(scene, {-0.45f, -0.45f, 0}, {0.9f, 0, 0}, {0, 0.9f, 0}, red);
    const int32_t square = scene.instances.back().mesh;
    slide(scene, left, {-1.5f, 0, 0});
    const int32_t still = builtin::add_node(scene, "still", {0, 1, 0});
    builtin::add_instance(scene, square, still);
    const int32_t right = builtin::add_node(scene, "right");
    builtin::add_instance(scene, square, right);
    slide(scene, right, {-0.5f, 0, 0});
    // The mesh' own node moves nothing.
    const int32_t skinned = add_quad(scene, {-0.45f, -0.45f, 0}, {0.9f, 0, 0}, {0, 0.9f, 0}, red);
    scene.nodes[static_cast<size_t>(skinned)].translation = {50, 0, 0};
    const int32_t joint = builtin::add_node(scene, "joint");
    slide(scene, joint, {0.5f, 0, 0});
    scene.skins.push_back({"skin", {joint}, {glm::mat4(1.0f)}});
    scene.instances.back().skin = 0;
    scene.meshes.back().influences.assign(4, {glm::u16vec4(uint16_t{0}), {1, 0, 0, 0}});
    const int32_t parent = builtin::add_node(scene, "parent");
    slide(scene, parent, {1.5f, 0, 0});
    for (const float y : {-0.5f, 0.5f}) {
      const int32_t half =
          builtin::add_node(scene, "half", {0, 0.45f * y, 0}, glm::quat(1, 0, 0, 0), parent);
      scene.nodes[static_cast<size_t>(half)].scale = {1, 0.5f, 1};
      builtin::add_instance(scene, square, half);
    }
    add_light(scene, LightKind::directional, 3.0f, {}, {0.3f, -0.4f, -1});
    return scene;
  }
  // Half of the loop at `place`, where the shot's time is; elsewhere before.
  static void slide(Scene& scene, int32_t node, const glm::vec3& place) {
    builtin::animate_translation(scene, node, 2, [=](float phase) {
      return phase == 0.5f ? place : place + glm::vec3(0, 3, 0);
    });
  }
  static constexpr Shot kShot{.extent = kExtent,
                              .time_s = 0.5f * builtin::kLoopSeconds,
                              .previous_time_s = 0.5f * builtin::kLoopSeconds};

  void ask(const Scene& scene, const std::function<void(Frame&, const Inputs&)>& what) {
    AskingTechnique technique(what);
    render(scene, kShot, &technique);
  }
  void read_back_view(Frame& frame, const Inputs& inputs, const std::string& prefix,
                      ViewContent content = {}) {
    content.objects = true;
    const GBuffer g = inputs.host->render_view(frame, inputs.view, kExtent, content);
    frame.recorder().read_back(prefix + "_depth", g.depth);
    frame.recorder().read_back(prefix + "_source", g.source);
    if (g.object.valid()) frame.recorder().read_back(prefix + "_object", g.object);
  }

  // 1 + the object that the ray meets at z = 0, by its place; 0 for the wall and what stands still.
  // kEdge: too near to an edge to say.
  static constexpr uint32_t kEdge = 255;
  static uint32_t object_along(const PixelRay& ray) {
    const glm::dvec3 p = *meet_plane(ray, {0, 0, 0}, {0, 0, 1});
    constexpr double kNear = 0.01;
    for (uint32_t object = 0; object < kObjects; ++object) {
      const double x = -1.5 + object, distance = std::max(std::abs(p.x - x), std::abs(p.y));
      if (std::abs(distance - 0.45) < kNear) return kEdge;
      if (distance < 0.45) return object + 1;
    }
    return 0;
  }
  uint32_t name_at(const std::string& image, const PixelRay& ray) {
    return static_cast<uint32_t>(std::lround(255.0f * at(image, ray).x));
  }
};

TEST_F(SceneHostObjectsTest, EachPixelNamesItsObject) {
  ask(stage(), [&](Frame& frame, const Inputs& inputs) {
    EXPECT_EQ(inputs.host->objects().size(), kObjects);
    frame.recorder().read_back("object", inputs.g_buffer.object);
    read_back_view(frame, inputs, "view");
  });
  std::array<size_t, kObjects + 1> seen{};
  for (const PixelRay& ray : rays()) {
    const uint32_t want = object_along(ray);
    ASSERT_EQ(name_at("view_object", ray), name_at("object", ray));
    if (want == kEdge) continue;
    ASSERT_EQ(name_at("object", ray), want) << ray.x << ", " << ray.y;
    ++seen[want];
    // The name is no one's transparency.
    ASSERT_EQ(at("source", ray).w, 1.0f);
    ASSERT_EQ(at("albedo", ray).w, 1.0f);
  }
  for (const size_t pixels : seen) EXPECT_GT(pixels, 60u);
}

TEST_F(SceneHostObjectsTest, WhereNothingMovesThereAreNone) {
  Scene scene = stage();
  scene.animation.clear();
  ask(scene, [&](Frame& frame, const Inputs& inputs) {
    EXPECT_TRUE(inputs.host->objects().empty());
    EXPECT_FALSE(inputs.g_buffer.object.valid());
    EXPECT_FALSE(
        inputs.host->render_view(frame, inputs.view, kExtent, {.objects = true}).object.valid());
  });
}

TEST_F(SceneHostObjectsTest, BoxesAreWhereTheyAreInThisFrame) {
  ask(stage(), [&](Frame&, const Inputs& inputs) {
    const std::span<const MovingObject> objects = inputs.host->objects();
    ASSERT_EQ(objects.size(), kObjects);
    for (uint32_t i = 0; i < kObjects; ++i) {
      const float x = -1.5f + static_cast<float>(i);
      const float half = 0.45f;
      const glm::vec3 low(x - half, -half, 0), high(x + half, half, 0);
      const Box& box = objects[i].bounds;
      EXPECT_LT(glm::distance(glm::make_vec3(box.min.data()), low), 1e-6f) << i;
      EXPECT_LT(glm::distance(glm::make_vec3(box.max.data()), high), 1e-6f) << i;
    }
  });
}

// What is left out is gone from its pixels and from no others: there is the wall, in the shadow
// that the object still casts.
TEST_F(SceneHostObjectsTest, ViewsLeaveOutWhatTheyAreTold) {
  const std::vector<std::vector<uint32_t>> left_out{{kLeft},   {kRight},         {kSkinned},
                                                    {kHalves}, {kLeft, kHalves}, {0, 1, 2, 3}};
  const auto prefix = [](size_t i) { return "without" + std::to_string(i); };
  ask(stage(), [&](Frame& frame, const Inputs& inputs) {
    read_back_view(frame, inputs, "all");
    for (size_t i = 0; i < left_out.size(); ++i)
      read_back_view(frame, inputs, prefix(i), {.without = left_out[i]});
    // Nothing that views share was made without them.
    read_back_view(frame, inputs, "again");
  });
  for (size_t i = 0; i < left_out.size(); ++i) {
    size_t gone = 0;
    for (const PixelRay& ray : rays()) {
      const uint32_t name = name_at("all_object", ray);
      const bool is_gone =
          name != 0 && std::ranges::find(left_out[i], name - 1) != left_out[i].end();
      gone += is_gone;
      const float depth = at(prefix(i) + "_depth", ray).x;
      if (is_gone) {
        ASSERT_EQ(name_at(prefix(i) + "_object", ray), 0u);
        ASSERT_NEAR(depth, 0.05f / 7.0f, 1e-6f);  // the wall's
      } else {
        ASSERT_EQ(name_at(prefix(i) + "_object", ray), name);
        ASSERT_EQ(depth, at("all_depth", ray).x);
        // Shadows are where they were.
        ASSERT_EQ(at(prefix(i) + "_source", ray), at("all_source", ray));
      }
      ASSERT_EQ(at("again_source", ray), at("all_source", ray));
    }
    EXPECT_GT(gone, 60 * left_out[i].size());
  }
}

// The wall behind the objects, as seen without them: a ray to the light meets one or it does not.
TEST_F(SceneHostObjectsTest, WhatIsLeftOutStillCastsItsShadow) {
  const std::vector<uint32_t> all{0, 1, 2, 3};
  ask(stage(), [&](Frame& frame, const Inputs& inputs) {
    read_back_view(frame, inputs, "without", {.without = all});
  });
  size_t dark = 0, light = 0;
  for (const PixelRay& ray : rays()) {
    PixelRay to_light = ray;
    to_light.origin = *meet_plane(ray, {0, 0, -2}, {0, 0, 1});
    to_light.direction = -glm::dvec3(0.3, -0.4, -1);
    const glm::dvec3 p = *meet_plane(to_light, {0, 0, 0}, {0, 0, 1});
    if (at("without_depth", ray).x > 0.05f / 6.9f) continue;  // what stands still
    // Well inside of an object, or well away from all and from what stands still above them.
    const double x = std::abs(std::remainder(p.x - 0.5, 1.0));
    const bool in_row = std::abs(p.x) < 2.0;
    const float radiance = at("without_source", ray).y;
    if (in_row && x < 0.4 && std::abs(p.y) < 0.4) {
      ASSERT_EQ(radiance, 0.0f) << ray.x << ", " << ray.y;
      ++dark;
    } else if (p.y < -0.5 || (p.y > 0.5 && std::abs(p.x) > 0.5)) {
      ASSERT_GT(radiance, 0.5f) << ray.x << ", " << ray.y;
      ++light;
    }
  }
  EXPECT_GT(dark, 150u);
  EXPECT_GT(light, 150u);
}

}  // namespace
}  // namespace lueur
