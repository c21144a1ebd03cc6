// SPDX-License-Identifier: MIT
// A rendering's name depends on all that decides its pixels, and on nothing else.
#include "reference/content.h"

#include <functional>
#include <set>

#include "reference/reference_fixture.h"
#include "scene/builtin/scene_builder.h"

namespace lueur::reference {
namespace {

struct Input {
  Scene scene;
  Shot shot{64, 48};
  Settings settings;
};

Input input() {
  Input in;
  in.scene = scene_seen_from({0, 1, 2}, {0, 0, 0});
  add_floor(in.scene, 1);
  add_light(in.scene, LightKind::spot, 3, {0, 2, 0});
  builtin::add_camera(in.scene, "other", {2, 1, 0}, {0, 0, 0}, 0.8f);
  in.scene.textures.push_back(
      {.name = "t", .width = 1, .height = 2, .rgba = {1, 2, 3, 4, 5, 6, 7, 8}});
  builtin::animate_translation(in.scene, in.scene.instances[0].node, 4,
                               [](float phase) { return glm::vec3(phase, 0, 0); });
  in.scene.materials[0].phong = PhongLobe{};
  return in;
}

std::string key(const Input& in) {
  return content_key(in.scene, in.shot, in.settings);
}

struct Change {
  const char* name;
  std::function<void(Input&)> make;
};

const std::vector<Change> kChanges = {
    {"vertex position", [](Input& i) { i.scene.meshes[0].vertices[2].position.y += 1e-6f; }},
    {"vertex normal", [](Input& i) { i.scene.meshes[0].vertices[2].normal.x = 0.1f; }},
    {"vertex tangent", [](Input& i) { i.scene.meshes[0].vertices[2].tangent.w = -1; }},
    {"vertex uv", [](Input& i) { i.scene.meshes[0].vertices[2].uv.x = 7; }},
    {"index",
     [](Input& i) { std::swap(i.scene.meshes[0].indices[0], i.scene.meshes[0].indices[1]); }},
    {"primitive", [](Input& i) { i.scene.meshes[0].primitives[0].index_count = 3; }},
    {"instance", [](Input& i) { i.scene.instances.push_back(i.scene.instances[0]); }},
    {"texel", [](Input& i) { i.scene.textures[0].rgba[5] ^= 1; }},
    {"texture size",
     [](Input& i) { std::swap(i.scene.textures[0].width, i.scene.textures[0].height); }},
    {"wrap u", [](Input& i) { i.scene.textures[0].wrap_u = Wrap::clamp_to_edge; }},
    {"wrap v", [](Input& i) { i.scene.textures[0].wrap_v = Wrap::clamp_to_edge; }},
    {"nearest", [](Input& i) { i.scene.textures[0].nearest = true; }},
    {"base colour", [](Input& i) { i.scene.materials[0].base_color.b = 0.5f; }},
    {"alpha", [](Input& i) { i.scene.materials[0].base_color.a = 0.5f; }},
    {"metallic", [](Input& i) { i.scene.materials[0].metallic = 0.5f; }},
    {"roughness", [](Input& i) { i.scene.materials[0].roughness = 0.5f; }},
    {"specular", [](Input& i) { i.scene.materials[0].specular = 0.5f; }},
    {"emission", [](Input& i) { i.scene.materials[0].emission.g = 0.5f; }},
    {"normal scale", [](Input& i) { i.scene.materials[0].normal_scale = 0.5f; }},
    {"base colour texture", [](Input& i) { i.scene.materials[0].base_color_texture = 0; }},
    {"metallic-roughness texture",
     [](Input& i) { i.scene.materials[0].metallic_roughness_texture = 0; }},
    {"normal texture", [](Input& i) { i.scene.materials[0].normal_texture = 0; }},
    {"emission texture", [](Input& i) { i.scene.materials[0].emission_texture = 0; }},
    {"no phong", [](Input& i) { i.scene.materials[0].phong.reset(); }},
    {"phong colour", [](Input& i) { i.scene.materials[0].phong->color.r = 1; }},
    {"phong exponent", [](Input& i) { i.scene.materials[0].phong->exponent = 9; }},
    {"phong c_xy", [](Input& i) { i.scene.materials[0].phong->c_xy = -0.5f; }},
    {"phong c_z", [](Input& i) { i.scene.materials[0].phong->c_z = 0.5f; }},
    {"alpha mode", [](Input& i) { i.scene.materials[0].alpha_mode = AlphaMode::mask; }},
    {"alpha cutoff", [](Input& i) { i.scene.materials[0].alpha_cutoff = 0.1f; }},
    {"double-sided", [](Input& i) { i.scene.materials[0].double_sided = true; }},
    {"light kind", [](Input& i) { i.scene.lights[0].kind = LightKind::point; }},
    {"light place",
     [](Input& i) {
       i.scene.nodes[static_cast<size_t>(i.scene.lights[0].node)].translation.x = 1;
     }},
    {"light direction",
     [](Input& i) {
       i.scene.nodes[static_cast<size_t>(i.scene.lights[0].node)].rotation = {1, 0, 0, 0};
     }},
    {"light colour", [](Input& i) { i.scene.lights[0].color.r = 0.5f; }},
    {"light intensity", [](Input& i) { i.scene.lights[0].intensity = 4; }},
    {"light inner cone", [](Input& i) { i.scene.lights[0].inner_cone_rad = 0.1f; }},
    {"light outer cone", [](Input& i) { i.scene.lights[0].outer_cone_rad = 0.5f; }},
    {"light range", [](Input& i) { i.scene.lights[0].range_m = 3.0f; }},
    {"no light", [](Input& i) { i.scene.lights.clear(); }},
    {"another light", [](Input& i) { i.scene.lights.push_back(i.scene.lights[0]); }},
    {"camera place", [](Input& i) { i.scene.nodes[0].translation.x = 1; }},
    {"field of view", [](Input& i) { i.scene.cameras[0].vertical_fov_rad = 1; }},
    {"near plane", [](Input& i) { i.scene.cameras[0].near_m = 1; }},
    {"width", [](Input& i) { i.shot.width = 65; }},
    {"height", [](Input& i) { i.shot.height = 47; }},
    {"camera", [](Input& i) { i.shot.camera = 1; }},
    {"time", [](Input& i) { i.shot.time_s = 1; }},
    {"mode", [](Input& i) { i.settings.mode = Mode::screen; }},
    {"bounces", [](Input& i) { i.settings.bounces = 2; }},
    {"seed", [](Input& i) { i.settings.seed = 1; }},
    {"distance", [](Input& i) { i.settings.ambient_distance_m = 2; }},
    {"form factor", [](Input& i) { i.settings.form_factor = FormFactor::point; }},
};

TEST(ContentKey, EveryChangeGivesAnother) {
  std::set<std::string> keys = {key(input())};
  for (const Change& change : kChanges) {
    Input in = input();
    change.make(in);
    EXPECT_TRUE(keys.insert(key(in)).second) << change.name;
  }
  for (const std::string& k : keys) EXPECT_EQ(k.size(), 32u);
}

TEST(ContentKey, NamesDoNotMatter) {
  Input in = input();
  in.scene.name = in.scene.materials[0].name = in.scene.meshes[0].name = "x";
  in.scene.textures[0].name = in.scene.nodes[0].name = in.scene.cameras[0].name = "y";
  in.scene.lights[0].name = "z";
  in.scene.warnings = {"something"};
  in.scene.exposure_ev = 3.0f;
  EXPECT_EQ(key(in), key(input()));
  EXPECT_EQ(finished_key(in.scene, in.shot, in.settings),
            finished_key(input().scene, in.shot, in.settings));
}

// More samples continue a rendering; a finished one is another.
TEST(ContentKey, SamplesAreOfTheFinishedKeyOnly) {
  Input more = input(), exact = input();
  more.settings.spp *= 2;
  exact.settings.target_error = 0.01;
  std::set<std::string> finished;
  for (const Input& in : {input(), more, exact}) {
    EXPECT_EQ(key(in), key(input()));
    finished.insert(finished_key(in.scene, in.shot, in.settings));
  }
  EXPECT_EQ(finished.size(), 3u);
}

}  // namespace
}  // namespace lueur::reference
