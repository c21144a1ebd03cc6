// SPDX-License-Identifier: MIT
// What the renderer does for techniques: other views, lights and triangles.
#include "renderer/scene_host.h"

#include <algorithm>
#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "renderer/asking_technique.h"
#include "renderer/renderer_fixture.h"
#include "renderer/test_shaders/params.h"
#include "renderer/test_shaders/shaders.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/shapes.h"
#include "scene/deform.h"
#include "scene/placed_light.h"

namespace lueur {
namespace {

constexpr size_t kLights = 3;

// Lights of each kind on white, glossy, glowing and cut out surfaces.
Scene furnished() {
  Scene scene = scene_seen_from({0, 1.5f, 4}, {0, 0.5f, 0});
  add_floor(scene, 3);
  const int32_t gloss = builtin::add_material(scene, "gloss", {0.7f, 0.3f, 0.1f}, 0.4f);
  scene.materials.back().metallic = 0.5f;
  add_quad(scene, {-1.4f, 0, -1}, {1, 0, 0.3f}, {0, 1.2f, 0}, gloss);
  const int32_t lamp = builtin::add_material(scene, "lamp", {0.5f, 0.5f, 0.5f}, 1.0f);
  scene.materials.back().emission = {0.25f, 0.5f, 0.75f};
  add_quad(scene, {0.4f, 0, -1}, {1, 0, -0.3f}, {0, 1.2f, 0}, lamp);
  add_light(scene, LightKind::point, 6.0f, {0.5f, 1.5f, 1.0f});
  add_light(scene, LightKind::spot, 20.0f, {-1, 2, 2}, {0.4f, -0.8f, -0.9f}).inner_cone_rad = 0.3f;
  add_light(scene, LightKind::directional, 2.0f, {}, {0.3f, -1, -0.4f});
  return scene;
}

View view_at(const glm::vec3& eye, const glm::mat4& clip_from_view) {
  View view;
  std::copy_n(glm::value_ptr(glm::translate(glm::mat4(1.0f), -eye)), 16,
              view.view_from_world.begin());
  std::copy_n(glm::value_ptr(clip_from_view), 16, view.clip_from_view.begin());
  return view;
}

void read_back(Frame& frame, const std::string& prefix, const GBuffer& g) {
  for (const auto& [name, image] : {std::pair{"depth", g.depth},
                                    {"normal", g.normal},
                                    {"source", g.source},
                                    {"emission", g.emission},
                                    {"albedo", g.albedo},
                                    {"reflectance", g.reflectance}})
    if (image.valid()) frame.recorder().read_back(prefix + name, image);
}

class SceneHostTest : public RendererTest {
 protected:
  void ask(const Scene& scene, const Shot& shot,
           const std::function<void(Frame&, const Inputs&)>& what) {
    AskingTechnique technique(what);
    render(scene, shot, &technique);
  }
  void ask(const Scene& scene, const std::function<void(Frame&, const Inputs&)>& what) {
    ask(scene, {.extent = kExtent}, what);
  }
  size_t times_written(const std::string& name) {
    const std::vector<std::string>& all = recorder().written_images();
    return static_cast<size_t>(std::count(all.begin(), all.end(), name));
  }
};

TEST_F(SceneHostTest, TheMainViewAskedForAgainIsTheSameToTheBit) {
  ask(furnished(), [](Frame& frame, const Inputs& inputs) {
    read_back(frame, "main_", inputs.g_buffer);
    const GBuffer view = inputs.host->render_view(frame, inputs.view, inputs.g_buffer.depth.extent);
    read_back(frame, "view_", view);
    // Where it was in the frame before is not known.
    EXPECT_FALSE(view.motion.valid());
  });
  size_t lit = 0;
  for (const char* name : {"depth", "normal", "source", "emission", "albedo", "reflectance"}) {
    const std::string main = std::string("main_") + name, view = std::string("view_") + name;
    for (const PixelRay& ray : rays()) {
      ASSERT_EQ(at(view, ray), at(main, ray)) << name << " at " << ray.x << ", " << ray.y;
      lit += at(view, ray).y > 0.0f ? 1 : 0;
    }
  }
  EXPECT_GT(lit, 5000u);
}

TEST_F(SceneHostTest, LightsAloneAndEmissionAddUpToAllOfThem) {
  ask(furnished(), [](Frame& frame, const Inputs& inputs) {
    ASSERT_EQ(inputs.host->lights().size(), kLights);
    for (int32_t light = 0; light < static_cast<int32_t>(kLights); ++light) {
      const GBuffer g = inputs.host->render_view(frame, inputs.view, inputs.g_buffer.depth.extent,
                                                 {.light = light});
      EXPECT_FALSE(g.emission.valid());
      read_back(frame, "light" + std::to_string(light) + "_", g);
    }
  });
  std::array<size_t, kLights> lit{};
  for (const PixelRay& ray : rays()) {
    glm::vec3 sum(at("emission", ray));
    for (size_t light = 0; light < kLights; ++light) {
      const glm::vec3 alone(at("light" + std::to_string(light) + "_source", ray));
      lit[light] += alone.y > 0.0f ? 1 : 0;
      sum += alone;
    }
    const glm::vec3 all(at("source", ray));
    // Each sum is rounded to a half float, and each light alone is.
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(all[c], sum[c], 2 * kLights * all[c] / 2048);
  }
  for (const size_t count : lit) EXPECT_GT(count, 200u);
}

// A plane that glows on its right half, from very far through an off-centre, narrow window.
TEST_F(SceneHostTest, ViewsMayBeFarNarrowAndOffCentre) {
  Scene scene = scene_seen_from({0, 0, 3}, {0, 0, 0});
  const int32_t lamp = builtin::add_material(scene, "lamp", {0.5f, 0.5f, 0.5f}, 1.0f);
  scene.materials.back().emission = glm::vec3(2.0f);
  add_quad(scene, {-4, -4, 0}, {4, 0, 0}, {0, 8, 0});
  add_quad(scene, {0, -4, 0}, {4, 0, 0}, {0, 8, 0}, lamp);
  add_light(scene, LightKind::directional, 3.0f, {}, {0, 0, -1});
  constexpr Extent kWindow{40, 20};
  constexpr float kFar = 800, kNear = 1, kLeft = -1.5f, kRight = 2.5f, kBottom = -1, kTop = 1.5f;
  glm::mat4 clip(0.0f);
  clip[0][0] = 2 * kFar / (kRight - kLeft);
  clip[2][0] = (kRight + kLeft) / (kRight - kLeft);
  clip[1][1] = -2 * kFar / (kTop - kBottom);
  clip[2][1] = -(kTop + kBottom) / (kTop - kBottom);
  clip[2][3] = -1;
  clip[3][2] = kNear;
  ask(scene, {.extent = kWindow}, [&](Frame& frame, const Inputs& inputs) {
    read_back(frame, "view_",
              inputs.host->render_view(frame, view_at({0, 0, kFar}, clip), kWindow));
  });
  constexpr float kLit = 3.0f / 3.14159265f;
  for (const PixelRay& ray : rays()) {
    const float x = kLeft + (kRight - kLeft) * (static_cast<float>(ray.x) + 0.5f) / 40;
    const float source = x < 0 ? kLit : 2 + 0.5f * kLit;
    // The lamp's albedo is kept in 8 bits of sRGB.
    ASSERT_NEAR(at("view_source", ray).y, source, 0.002f * source) << "at " << x;
    ASSERT_NEAR(at("view_depth", ray).x, kNear / kFar, 1e-5f * kNear / kFar);
  }
}

TEST_F(SceneHostTest, ShadowMapsAreDrawnOnceAFrame) {
  Scene scene = furnished();
  const auto two_views = [](Frame& frame, const Inputs& inputs) {
    for (int i = 0; i < 2; ++i)
      inputs.host->render_view(frame, inputs.view, inputs.g_buffer.depth.extent);
  };
  ask(scene, two_views);
  // Six faces around the point light, one map for each of the others.
  EXPECT_EQ(times_written("renderer.shadow.shadow_map"), 8u);
  EXPECT_EQ(times_written("renderer.view.light.source"), 2 * kLights);
  // A third sun finds no room.
  add_light(scene, LightKind::directional, 2.0f, {}, {0, -1, 0});
  add_light(scene, LightKind::directional, 2.0f, {}, {0, -1, 1});
  ask(scene, two_views);
  EXPECT_GT(times_written("renderer.shadow.shadow_map"), 10u);
}

TEST_F(SceneHostTest, LightsAreWhereTheirNodesPutThem) {
  Scene scene = furnished();
  const int32_t parent = builtin::add_node(scene, "parent", {1, 2, 3});
  // A parent stands before its children.
  scene.lights[1].node =
      builtin::add_node(scene, "child", {0, 1, 0}, builtin::look_along({1, -1, 0}), parent);
  scene.lights[0].range_m = 7.0f;
  scene.lights[0].color = {0.25f, 0.5f, 1};
  builtin::animate_translation(scene, parent, 4,
                               [](float phase) { return glm::vec3(4 * phase, 0, 0); });
  const Shot shot{.extent = kExtent, .time_s = 2.5f};
  ask(scene, shot, [&](Frame&, const Inputs& inputs) {
    const std::vector<glm::mat4> posed = pose(scene, shot.time_s);
    const std::span<const PunctualLight> lights = inputs.host->lights();
    ASSERT_EQ(lights.size(), scene.lights.size());
    for (size_t i = 0; i < lights.size(); ++i) {
      const PlacedLight placed =
          place(scene.lights[i], posed[static_cast<size_t>(scene.lights[i].node)]);
      EXPECT_EQ(glm::make_vec3(lights[i].position.data()), placed.position_world);
      EXPECT_EQ(glm::make_vec3(lights[i].direction.data()), placed.direction_world);
      EXPECT_EQ(glm::make_vec3(lights[i].intensity.data()), placed.intensity);
    }
    EXPECT_EQ(lights[0].kind, PunctualLight::Kind::point);
    EXPECT_EQ(lights[1].kind, PunctualLight::Kind::spot);
    EXPECT_EQ(lights[2].kind, PunctualLight::Kind::directional);
    EXPECT_EQ(glm::make_vec3(lights[0].intensity.data()), 6.0f * scene.lights[0].color);
    EXPECT_FLOAT_EQ(lights[0].range_m, 7.0f);
    EXPECT_FLOAT_EQ(lights[1].inner_cone_rad, 0.3f);
    EXPECT_FLOAT_EQ(lights[1].outer_cone_rad, 0.7854f);
    EXPECT_FLOAT_EQ(lights[1].position[0], 1.0f);
    EXPECT_FLOAT_EQ(lights[1].position[1], 1.0f);
    EXPECT_NEAR(lights[1].direction[0], 0.70710678f, 1e-6f);
  });
}

using Triangle = std::array<float, 9>;

// The corners of all triangles as the CPU poses them, in some order.
std::vector<Triangle> triangles_of(const Scene& scene, float time_s) {
  const Scene still = with_deformed_meshes(scene, time_s);
  const std::vector<glm::mat4> posed = pose(still, time_s);
  std::vector<Triangle> list;
  for (const MeshInstance& instance : still.instances) {
    const Mesh& mesh = still.meshes[static_cast<size_t>(instance.mesh)];
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      Triangle& triangle = list.emplace_back();
      for (size_t k = 0; k < 3; ++k) {
        const glm::vec4 p = posed[static_cast<size_t>(instance.node)] *
                            glm::vec4(mesh.vertices[mesh.indices[i + k]].position, 1.0f);
        for (int c = 0; c < 3; ++c) triangle[3 * k + static_cast<size_t>(c)] = p[c];
      }
    }
  }
  return list;
}

// Numbers are such that floats hold all sums, so that CPU and device agree to the bit.
TEST_F(SceneHostTest, TrianglesAreThoseThatAreDrawn) {
  Scene scene = scene_seen_from({0, 0, 3}, {0, 0, 0});
  const int32_t placed = add_quad(scene, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
  scene.nodes[static_cast<size_t>(placed)].scale = {-2, 1, 0.5f};
  builtin::add_instance(scene, 0, builtin::add_node(scene, "again", {4, 0, -8}));
  add_quad(scene, {0.5f, 0, 1}, {0.25f, 0, 0}, {0, 0, 0.125f});
  add_quad(scene, {-0.5f, 1, 0}, {1, 0, 0}, {0, 1, 0});
  scene.meshes.back().morph_targets.push_back(
      {{{0, 0, 0}, {0, 0.5f, 0}, {0.25f, 0, 0}, {0, 0, 2}}, {}, {}});
  scene.instances.back().morph_weights = {0.5f};
  add_quad(scene, {-0.5f, -2, 0}, {1, 0, 0}, {0, 1, 0});
  const int32_t joint = builtin::add_node(scene, "joint", {0, 8, 0});
  scene.skins.push_back({"skin", {joint}, {glm::mat4(1.0f)}});
  scene.instances.back().skin = 0;
  scene.meshes.back().influences.assign(4, {glm::u16vec4(uint16_t{0}), {1, 0, 0, 0}});

  std::vector<std::string> names;
  ask(scene, [&](Frame& frame, const Inputs& inputs) {
    for (const TriangleBatch& batch : inputs.host->triangles(frame)) {
      for (const TriangleRange& range : batch.ranges) {
        names.push_back("range" + std::to_string(names.size()));
        const Extent extent{range.index_count, 1};
        // A name that the scan expects negative numbers of.
        const Image geometry = frame.recorder().image("geometry", extent, Format::rgba32f);
        frame.recorder().dispatch(
            "test.corners",
            {.shader = shaders::renderer_test_shaders_corners_comp,
             .params = CornerParams{glm::make_mat4(range.world_from_object.data()),
                                    range.first_index, range.index_count, range.vertex_offset,
                                    batch.first_float, batch.stride_floats},
             .read = {{"vertices", batch.vertices}, {"indices", batch.indices}},
             .write = {{"geometry", geometry}},
             .over = extent});
        frame.recorder().read_back(names.back(), geometry);
      }
    }
    const Bounds box = bounds_at(scene, 0);
    EXPECT_EQ(glm::make_vec3(inputs.host->bounds().min.data()), box.min);
    EXPECT_EQ(glm::make_vec3(inputs.host->bounds().max.data()), box.max);
  });
  std::vector<Triangle> given;
  for (const std::string& name : names) {
    const std::vector<float> corners = pixels(name).samples;
    for (size_t i = 0; i + 12 <= corners.size(); i += 12)
      given.push_back({corners[i], corners[i + 1], corners[i + 2], corners[i + 4], corners[i + 5],
                       corners[i + 6], corners[i + 8], corners[i + 9], corners[i + 10]});
  }
  std::vector<Triangle> want = triangles_of(scene, 0);
  EXPECT_EQ(want.size(), 10u);
  std::sort(given.begin(), given.end());
  std::sort(want.begin(), want.end());
  EXPECT_EQ(given, want);
}

// Triangles that bound solids come in ranges of their own, and what has holes bounds nothing.
TEST_F(SceneHostTest, RangesTellWhatIsClosed) {
  for (const bool has_holes : {false, true}) {
    Scene scene = scene_seen_from({0, 0, 3}, {0, 0, 0});
    add_quad(scene, {-1, -1, 0}, {1, 0, 0}, {0, 1, 0});
    Mesh& mesh = scene.meshes.back();
    // A tetrahedron beside the quad, in the same mesh, its four triangles looking outwards.
    const auto first = static_cast<uint32_t>(mesh.vertices.size());
    for (const glm::vec3 p : {glm::vec3(2, 0, 0), {3, 0, 0}, {2, 1, 0}, {2, 0, 1}}) {
      mesh.vertices.push_back(mesh.vertices.front());
      mesh.vertices.back().position = p;
    }
    for (const uint32_t corner : {0u, 2u, 1u, 0u, 1u, 3u, 0u, 3u, 2u, 1u, 2u, 3u})
      mesh.indices.push_back(first + corner);
    mesh.primitives.back().index_count += 12;
    if (has_holes) scene.materials.back().alpha_mode = AlphaMode::mask;
    ask(scene, [&](Frame& frame, const Inputs& inputs) {
      uint32_t closed = 0, open = 0;
      const std::span<const TriangleBatch> batches = inputs.host->triangles(frame);
      // Whoever asks again leaves valid what the first one holds.
      EXPECT_EQ(inputs.host->triangles(frame).data(), batches.data());
      for (const TriangleBatch& batch : batches)
        for (const TriangleRange& range : batch.ranges) {
          // Closed ones are put first.
          EXPECT_EQ(range.first_index, range.closed || has_holes ? 0u : 12u);
          (range.closed ? closed : open) += range.index_count / 3;
        }
      EXPECT_EQ(closed, has_holes ? 0u : 4u);
      EXPECT_EQ(open, has_holes ? 6u : 2u);
    });
  }
}

// Each solid's ranges tell how thick it is, the thinnest first, and cover the mesh once.
TEST_F(SceneHostTest, RangesTellHowThickSolidsAre) {
  Scene scene = scene_seen_from({0, 0, 3}, {0, 0, 0});
  builtin::MeshBuilder builder;
  builtin::add_box(builder, {-1, -1, -1}, {1, 1, 1}, {100.0f});
  builtin::add_box(builder, {2, -1, -1}, {2.01f, 1, 1}, {100.0f});
  builtin::add_box(builder, {3, -1, -1}, {4.9f, 1, 1}, {100.0f});
  scene.meshes.push_back(builder.finish("boxes"));
  scene.instances.push_back({.node = 0, .mesh = 0});
  ask(scene, [&](Frame& frame, const Inputs& inputs) {
    const std::vector<TriangleRange>& ranges = inputs.host->triangles(frame)[0].ranges;
    ASSERT_EQ(ranges.size(), 2u);
    EXPECT_EQ(ranges[0].index_count, 36u);
    EXPECT_NEAR(ranges[0].thickness, 2 * 0.04 / 8.08, 1e-5);
    EXPECT_EQ(ranges[1].first_index, 36u);
    EXPECT_EQ(ranges[1].index_count, 72u);
    EXPECT_NEAR(ranges[1].thickness, 2 * 7.6 / 23.2, 1e-5);  // 1.9 m, and not 2 m
    EXPECT_TRUE(ranges[0].closed && ranges[1].closed);
  });
}

}  // namespace
}  // namespace lueur
