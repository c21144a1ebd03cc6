// SPDX-License-Identifier: MIT
// What the renderer gives to techniques without being asked.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <optional>

#include "lueur/hierarchical.h"
#include "renderer/asking_technique.h"
#include "renderer/renderer_fixture.h"
#include "scene/builtin/scene_builder.h"

namespace lueur {
namespace {

// A wall that fills the view.
Scene wall(const Material& material) {
  Scene scene = scene_seen_from({0, 0, 3}, {0, 0, 0});
  scene.materials.push_back(material);
  add_quad(scene, {-4, -4, 0}, {8, 0, 0}, {0, 8, 0}, 1);
  return scene;
}

class TechniqueInputsTest : public RendererTest {
 protected:
  Inputs inputs_for(const Scene& scene, const Shot& shot = {.extent = kExtent}) {
    Inputs seen;
    AskingTechnique technique([&](Frame& frame, const Inputs& inputs) {
      seen = inputs;
      const GBuffer& g = inputs.g_buffer;
      for (const auto& [name, image] : {std::pair{"given_albedo", g.albedo},
                                        {"given_motion", g.motion},
                                        {"given_reflectance", g.reflectance},
                                        {"given_emission", g.emission}})
        if (image.valid()) frame.recorder().read_back(name, image);
    });
    render(scene, shot, &technique);
    return seen;
  }
};

TEST_F(TechniqueInputsTest, ReflectanceIsThatOfTheMaterial) {
  Material material;
  material.base_color = {1.0f, 0.5f, 0.25f, 1.0f};
  material.metallic = 0.5f;
  material.roughness = 0.1f;
  material.specular = 0.5f;
  inputs_for(wall(material));
  const PixelRay middle = rays()[24 * 64 + 32];
  const glm::vec4 reflectance = at("given_reflectance", middle);
  // Half of a dielectric's 0.04, then half way to the base colour; 8 bits hold all numbers.
  const float exact[] = {0.51f, 0.26f, 0.135f};
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(reflectance[c], exact[c], 0.004f) << c;
  EXPECT_NEAR(reflectance.a, 0.1f, 0.51f / 255 + 2e-4f);
  EXPECT_EQ(at("given_albedo", middle), at("albedo", middle));
}

// Panels with lobes in another order than the materials', two of one shape, and one of GGX between.
TEST_F(TechniqueInputsTest, ReflectanceNamesTheMaterialsCosineLobe) {
  Scene scene = scene_seen_from({0, 0, 3}, {0, 0, 0});
  const std::array<std::optional<PhongLobe>, 5> lobes{
      PhongLobe{{0.25f, 0.5f, 0.75f}, 12}, PhongLobe{{0.5f, 0.125f, 1}, 20, -1, 0.5f}, std::nullopt,
      PhongLobe{{1, 0.0625f, 0.25f}, 12}, PhongLobe{{0.5f, 0.5f, 0.5f}, 20, -0.5f, 1}};
  // More lobes than 8 bits can count come first.
  for (int i = 0; i < 300; ++i) {
    builtin::add_material(scene, "not seen", glm::vec3(0.5f));
    scene.materials.back().phong = PhongLobe{glm::vec3(0.001f * static_cast<float>(i)), 99};
  }
  for (size_t i = lobes.size(); i-- > 0;) {
    const int32_t material = builtin::add_material(scene, "panel", glm::vec3(0.5f), 0.6f);
    scene.materials.back().phong = lobes[i];
    add_quad(scene, {static_cast<float>(i) - 2.5f, -4, 0}, {1, 0, 0}, {0, 8, 0}, material);
    // The index and this mark share bits.
    scene.instances.back().passes_light_on = i % 2 == 0;
  }
  std::vector<CosineLobe> table;
  AskingTechnique technique([&](Frame& frame, const Inputs& inputs) {
    table.assign(inputs.lobes.begin(), inputs.lobes.end());
    const GBuffer view = inputs.host->render_view(frame, inputs.view, kExtent);
    frame.recorder().read_back("given_reflectance", inputs.g_buffer.reflectance);
    frame.recorder().read_back("view_reflectance", view.reflectance);
  });
  render(scene, {.extent = kExtent}, &technique);
  EXPECT_EQ(table.size(), 4u);
  std::array<size_t, lobes.size()> seen{};
  for (const PixelRay& ray : rays()) {
    const double along = meet_plane(ray, {}, {0, 0, 1})->x + 2.5;
    if (along < 0 || along > 5 || std::abs(along - std::round(along)) < 0.02) continue;
    const auto panel = static_cast<size_t>(along);
    const glm::vec4 given = at("given_reflectance", ray);
    ASSERT_EQ(at("view_reflectance", ray), given);
    ++seen[panel];
    if (!lobes[panel]) {
      ASSERT_NEAR(given.a, 0.6f, 0.51f / 255 + 2e-4f);
      continue;
    }
    const PhongLobe& want = *lobes[panel];
    ASSERT_EQ(glm::vec3(given), want.color) << panel;
    ASSERT_LE(given.a, -1.0f);
    const auto index = static_cast<size_t>(-1.0f - given.a);
    ASSERT_LT(index, table.size());
    ASSERT_EQ(table[index].exponent, want.exponent) << panel;
    ASSERT_EQ(table[index].c_xy, want.c_xy) << panel;
    ASSERT_EQ(table[index].c_z, want.c_z) << panel;
  }
  for (const size_t count : seen) EXPECT_GT(count, 100u);
}

TEST_F(TechniqueInputsTest, EmissionIsThereWhereSomethingEmits) {
  Material material;
  material.metallic = 0;
  EXPECT_FALSE(inputs_for(wall(material)).g_buffer.emission.valid());
  material.emission = {0, 0, 2};
  EXPECT_TRUE(inputs_for(wall(material)).g_buffer.emission.valid());
  EXPECT_EQ(at("given_emission", rays()[0]), glm::vec4(0, 0, 2, 1));
  material.emission = {};
  material.unlit = true;
  EXPECT_TRUE(inputs_for(wall(material)).g_buffer.emission.valid());
}

TEST_F(TechniqueInputsTest, MotionLeadsToThePreviousView) {
  Scene scene = wall({});
  AnimationChannel channel;
  channel.node = scene.cameras[0].node;
  channel.times_s = {0.0f, 1.0f};
  channel.values = {{0, 0, 3, 0}, {1, 0, 3, 0}};
  scene.animation.push_back(channel);
  const Shot shot{.extent = kExtent, .time_s = 0.5f, .previous_time_s = 0.25f, .seed = 7};
  const Inputs inputs = inputs_for(scene, shot);
  EXPECT_EQ(inputs.seed, 7u);
  EXPECT_EQ(inputs.view.view_from_world, view_of(scene, shot).view_from_world);
  const View before = view_of(scene, {.extent = kExtent, .time_s = 0.25f});
  EXPECT_EQ(inputs.previous_view.view_from_world, before.view_from_world);
  EXPECT_EQ(inputs.previous_view.clip_from_view, before.clip_from_view);
  for (const PixelRay& ray : rays()) {
    // The wall's point that is seen here now, in the picture before.
    const auto p = meet_plane(ray, {}, {0, 0, 1});
    ASSERT_TRUE(p);
    const glm::vec4 clip = glm::make_mat4(inputs.previous_view.clip_from_view.data()) *
                           glm::make_mat4(inputs.previous_view.view_from_world.data()) *
                           glm::vec4(glm::vec3(*p), 1.0f);
    const float uv_before = 0.5f + 0.5f * clip.x / clip.w;
    const float uv_now = (static_cast<float>(ray.x) + 0.5f) / kExtent.width;
    ASSERT_NEAR(at("given_motion", ray).x, uv_now - uv_before, 1e-4f);
  }
}

// A floor, and two glowing, glossy panels on it, one of which may keep its light.
Scene two_panels(bool second_passes_light_on) {
  Scene scene = scene_seen_from({0, 1.2f, 3}, {0, 0.5f, 0});
  add_floor(scene, 2);
  const int32_t glow = builtin::add_material(scene, "glow", {0.75f, 0.5f, 0.25f}, 0.3f);
  scene.materials.back().emission = {0.5f, 1.0f, 0.25f};
  add_quad(scene, {-1, 0, -0.5f}, {0.8f, 0, 0}, {0, 1, 0}, glow);
  add_quad(scene, {0.2f, 0, -0.5f}, {0.8f, 0, 0}, {0, 1, 0}, glow);
  scene.instances.back().passes_light_on = second_passes_light_on;
  add_light(scene, LightKind::point, 8.0f, {0.3f, 1.4f, 1.5f});
  add_light(scene, LightKind::directional, 1.0f, {}, {0, -1, -1});
  return scene;
}

TEST_F(TechniqueInputsTest, WhatPassesNoLightOnIsSeenAndBlackToTechniques) {
  struct Seen {
    glm::vec4 composed, source, specular, albedo, emission;
  };
  std::vector<Seen> free;
  inputs_for(two_panels(true));
  for (const PixelRay& ray : rays())
    free.push_back({at("composed", ray), at("source", ray), at("specular", ray),
                    at("given_albedo", ray), at("given_emission", ray)});
  inputs_for(two_panels(false));
  size_t kept = 0, others = 0;
  for (const PixelRay& ray : rays()) {
    const auto on_panel = meet_plane(ray, {0, 0, -0.5}, {0, 0, 1});
    ASSERT_TRUE(on_panel);
    const auto inside = [](double x, double low, double high, double seam) {
      return x > low + seam && x < high - seam;
    };
    const bool is_kept = inside(on_panel->x, 0.2, 1, 0.02) && inside(on_panel->y, 0, 1, 0.02);
    const bool is_other = !inside(on_panel->x, 0.2, 1, -0.02) || !inside(on_panel->y, 0, 1, -0.02);
    const Seen& want = free[ray.index];
    // Each of the sums is rounded to a half float: emission, two lights, the composition.
    for (int c = 0; c < 3; ++c)
      ASSERT_NEAR(at("composed", ray)[c], want.composed[c], 6 * want.composed[c] / 2048);
    ASSERT_EQ(at("composed", ray).a, want.composed.a);
    if (is_kept) {
      ASSERT_EQ(glm::vec3(at("source", ray)), glm::vec3(0.0f));
      ASSERT_EQ(glm::vec3(at("given_albedo", ray)), glm::vec3(0.0f));
      ASSERT_EQ(glm::vec3(at("given_emission", ray)), glm::vec3(0.0f));
      // For the composition and for files it is as it was.
      ASSERT_EQ(at("albedo", ray), want.albedo);
      ASSERT_EQ(at("emission", ray), want.emission);
      ++kept;
    } else if (is_other) {
      ASSERT_EQ(at("source", ray), want.source);
      ASSERT_EQ(at("specular", ray), want.specular);
      ASSERT_EQ(at("given_albedo", ray), want.albedo);
      ASSERT_EQ(at("given_emission", ray), want.emission);
      ++others;
    }
  }
  EXPECT_GT(kept, 150u);
  EXPECT_GT(others, 1000u);
}

// Where all that is lit keeps its light there is none to gather.
TEST_F(TechniqueInputsTest, NothingIsGatheredFromWhatPassesNoLightOn) {
  for (const bool passes : {true, false}) {
    Scene scene = two_panels(passes);
    for (MeshInstance& instance : scene.instances) instance.passes_light_on = passes;
    Hierarchical technique;
    render(scene, {.extent = kExtent}, &technique);
    float brightest = 0.0f;
    for (const PixelRay& ray : rays()) brightest = std::max(brightest, at("indirect", ray).y);
    if (passes)
      EXPECT_GT(brightest, 0.01f);
    else
      EXPECT_EQ(brightest, 0.0f);
  }
}

// They are those of their cameras at the time of the frame, in the order of the shot.
TEST_F(TechniqueInputsTest, SideViewsAreThoseOfOtherCameras) {
  Scene scene = wall({});
  for (const float x : {2.0f, -2.0f})
    builtin::add_camera(scene, "side", {x, 0, 3}, {0, 0, 0}, 0.5f + 0.1f * x);
  AnimationChannel channel;
  channel.node = scene.cameras[2].node;
  channel.times_s = {0.0f, 1.0f};
  channel.values = {{-2, 0, 3, 0}, {-2, 1, 3, 0}};
  scene.animation.push_back(channel);
  std::vector<View> views;
  AskingTechnique technique([&](Frame&, const Inputs& inputs) {
    views.assign(inputs.side_views.begin(), inputs.side_views.end());
  });
  render(scene, {.extent = {32, 8}, .time_s = 0.5f, .side_cameras = {2, 1}}, &technique);
  ASSERT_EQ(views.size(), 2u);
  for (const size_t i : {0u, 1u}) {
    const View expected =
        view_of(scene, {.extent = {32, 8}, .camera = i == 0 ? 2 : 1, .time_s = 0.5f});
    EXPECT_EQ(views[i].view_from_world, expected.view_from_world) << i;
    EXPECT_EQ(views[i].clip_from_view, expected.clip_from_view) << i;
  }
  render(scene, {.extent = {32, 8}}, &technique);
  EXPECT_TRUE(views.empty());
}

// A cut is what the program says, the first frame, and a change of camera or extent; each history
// has its own.
TEST_F(TechniqueInputsTest, CutsAreToldAndSeen) {
  Scene scene = wall({});
  scene.cameras.push_back(scene.cameras[0]);
  auto renderer = Renderer::create(system(), context(), scene);
  ASSERT_TRUE(renderer.ok());
  const auto is_cut = [&](const Shot& shot, const char* history) {
    std::optional<bool> cut;
    AskingTechnique technique([&](Frame&, const Inputs& inputs) { cut = inputs.cut; });
    recorder().options.history_of = history;
    run([&](Frame& frame) { (*renderer)->record(frame, shot, &technique); });
    return cut.value();
  };
  const Shot shot{.extent = {8, 8}};
  EXPECT_TRUE(is_cut(shot, "a"));
  EXPECT_FALSE(is_cut(shot, "a"));
  EXPECT_TRUE(is_cut(shot, "b"));
  EXPECT_FALSE(is_cut(shot, "a"));
  EXPECT_TRUE(is_cut({.extent = {8, 8}, .cut = true}, "a"));
  EXPECT_FALSE(is_cut(shot, "a"));
  EXPECT_TRUE(is_cut({.extent = {8, 4}}, "a"));
  EXPECT_FALSE(is_cut({.extent = {8, 4}}, "a"));
  EXPECT_TRUE(is_cut({.extent = {8, 4}, .camera = 1}, "a"));
  EXPECT_FALSE(is_cut({.extent = {8, 4}, .camera = 1}, "a"));
  EXPECT_FALSE(is_cut(shot, "b"));
}

}  // namespace
}  // namespace lueur
