// SPDX-License-Identifier: MIT
// What skins and morph targets move, against the same surface moved by its node.
#include <glm/gtc/quaternion.hpp>

#include "renderer/renderer_fixture.h"
#include "scene/builtin/scene_builder.h"

namespace lueur {
namespace {

constexpr int32_t kQuadMesh = 0;

class DeformTest : public RendererTest {
 protected:
  // A square that turns and moves, by its node alone.
  static Scene rigid() {
    Scene scene = scene_seen_from({0, 0, 3}, {0, 0, 0});
    const int32_t node = add_quad(scene, {-0.6f, -0.6f, 0}, {1.2f, 0, 0}, {0, 1.2f, 0});
    move(scene, node);
    return scene;
  }
  static void move(Scene& scene, int32_t node) {
    builtin::animate_translation(scene, node, 4,
                                 [](float phase) { return glm::vec3(phase, 0.5f * phase, 0); });
    builtin::animate_rotation(scene, node, 4, [](float phase) {
      return glm::angleAxis(phase, glm::normalize(glm::vec3(0.2f, 1, 0.3f)));
    });
  }
  // The same, by a joint; the mesh' own node is elsewhere.
  static Scene skinned() {
    Scene scene = scene_seen_from({0, 0, 3}, {0, 0, 0});
    const int32_t node = add_quad(scene, {-0.6f, -0.6f, 0}, {1.2f, 0, 0}, {0, 1.2f, 0});
    scene.nodes[static_cast<size_t>(node)].translation = {50, 0, 0};
    const int32_t joint = builtin::add_node(scene, "joint");
    move(scene, joint);
    scene.skins.push_back({"skin", {joint}, {glm::mat4(1.0f)}});
    scene.instances.back().skin = 0;
    scene.meshes[kQuadMesh].influences.assign(4, {glm::u16vec4(uint16_t{0}), {1, 0, 0, 0}});
    return scene;
  }
};

TEST_F(DeformTest, SkinnedSurfaceLooksAndMovesLikeARigidOne) {
  const Shot shot{.extent = kExtent, .time_s = 1.0f, .previous_time_s = 0.6f};
  struct Seen {
    glm::vec4 depth, normal, motion;
  };
  std::vector<Seen> want;
  render(rigid(), shot);
  for (const PixelRay& ray : rays())
    want.push_back({at("depth", ray), at("normal", ray), at("motion", ray)});
  render(skinned(), shot);
  size_t seen = 0, others = 0;
  for (const PixelRay& ray : rays()) {
    const Seen& w = want[ray.index];
    if (w.depth.x == 0.0f || at("depth", ray).x == 0.0f) {
      others += w.depth.x != at("depth", ray).x;
      continue;
    }
    ++seen;
    EXPECT_NEAR(at("depth", ray).x, w.depth.x, 1e-5f * w.depth.x);
    EXPECT_LT(glm::distance(at("normal", ray), w.normal), 1e-4f);
    // Motion is a half float, of about 0.02 here.
    EXPECT_LT(glm::distance(at("motion", ray), w.motion), 5e-5f);
    EXPECT_GT(glm::length(glm::vec2(w.motion)), 5e-3f);
  }
  EXPECT_GT(seen, 300u);
  EXPECT_LE(others, 2u);  // pixels that an edge just touches
}

TEST_F(DeformTest, MorphedSurfaceIsWhereItsWeightSays) {
  Scene scene = scene_seen_from({0, 0, 3}, {0, 0, 0});
  add_quad(scene, {-0.6f, -0.6f, 0}, {1.2f, 0, 0}, {0, 1.2f, 0});
  scene.cameras[0].near_m = 0.1f;
  scene.meshes[kQuadMesh].morph_targets.push_back(
      {std::vector<glm::vec3>(4, glm::vec3(0, 0, 2)), {}, {}});
  scene.instances.back().morph_weights = {0.25f};
  render(scene);
  size_t seen = 0;
  for (const PixelRay& ray : rays()) {
    if (at("depth", ray).x == 0.0f) continue;
    EXPECT_NEAR(at("depth", ray).x, 0.1f / 2.5f, 1e-6f);
    ++seen;
  }
  EXPECT_GT(seen, 300u);
}

}  // namespace
}  // namespace lueur
