// SPDX-License-Identifier: MIT
// What every built-in scene promises.
#include "scene/builtin/builtin.h"

#include <cstring>

#include "scene/builtin/builtin_fixture.h"
#include "scene/watertight.h"

namespace lueur {
namespace {

// Volume enclosed; positive if the triangles are counter-clockwise outwards.
double signed_volume(const Mesh& mesh) {
  double volume = 0.0;
  for (size_t k = 0; k < mesh.indices.size(); k += 3) {
    const glm::dvec3 a = mesh.vertices[mesh.indices[k]].position;
    const glm::dvec3 b = mesh.vertices[mesh.indices[k + 1]].position;
    const glm::dvec3 c = mesh.vertices[mesh.indices[k + 2]].position;
    volume += glm::dot(a, glm::cross(b, c)) / 6.0;
  }
  return volume;
}

class EveryBuiltin : public testing::TestWithParam<std::string> {};

TEST_P(EveryBuiltin, IsTheSameEveryTime) {
  const Scene& a = make(GetParam());
  const Scene b = make_anew(GetParam());
  ASSERT_EQ(a.meshes.size(), b.meshes.size());
  for (size_t m = 0; m < a.meshes.size(); ++m) {
    ASSERT_EQ(a.meshes[m].vertices.size(), b.meshes[m].vertices.size());
    EXPECT_EQ(std::memcmp(a.meshes[m].vertices.data(), b.meshes[m].vertices.data(),
                          a.meshes[m].vertices.size() * sizeof(Vertex)),
              0)
        << a.meshes[m].name;
    EXPECT_EQ(a.meshes[m].indices, b.meshes[m].indices);
  }
  ASSERT_EQ(a.textures.size(), b.textures.size());
  for (size_t t = 0; t < a.textures.size(); ++t)
    EXPECT_TRUE(a.textures[t].rgba == b.textures[t].rgba) << a.textures[t].name;
  ASSERT_EQ(a.animation.size(), b.animation.size());
  for (size_t c = 0; c < a.animation.size(); ++c)
    EXPECT_EQ(a.animation[c].values, b.animation[c].values);
}

TEST_P(EveryBuiltin, HasValidIndicesAndVertices) {
  const Scene scene = make(GetParam());
  for (const Mesh& mesh : scene.meshes) {
    for (const uint32_t index : mesh.indices) ASSERT_LT(index, mesh.vertices.size());
    uint32_t covered = 0;
    for (const Primitive& primitive : mesh.primitives) {
      EXPECT_EQ(primitive.first_index, covered);
      EXPECT_EQ(primitive.index_count % 3, 0u);
      ASSERT_LT(size_t(primitive.material), scene.materials.size());
      covered += primitive.index_count;
    }
    EXPECT_EQ(covered, mesh.indices.size());
    for (const Vertex& v : mesh.vertices) {
      ASSERT_TRUE(std::isfinite(v.position.x + v.position.y + v.position.z)) << mesh.name;
      ASSERT_TRUE(std::isfinite(v.uv.x + v.uv.y)) << mesh.name;
      ASSERT_NEAR(glm::length(v.normal), 1.0f, 1e-5f) << mesh.name;
      ASSERT_NEAR(glm::length(glm::vec3(v.tangent)), 1.0f, 1e-5f) << mesh.name;
      ASSERT_NEAR(glm::dot(v.normal, glm::vec3(v.tangent)), 0.0f, 1e-4f) << mesh.name;
      ASSERT_EQ(std::abs(v.tangent.w), 1.0f) << mesh.name;
    }
  }
}

TEST_P(EveryBuiltin, IsClosedAndFacesOutwards) {
  for (const Mesh& mesh : make(GetParam()).meshes) {
    EXPECT_EQ(watertightness(mesh).open_triangles, 0u) << mesh.name;
    EXPECT_GT(signed_volume(mesh), 0.0) << mesh.name;
  }
}

TEST_P(EveryBuiltin, NormalsAgreeWithTheWinding) {
  for (const Mesh& mesh : make(GetParam()).meshes) {
    size_t corners = 0, disagree = 0;
    for (size_t k = 0; k < mesh.indices.size(); k += 3) {
      const Vertex* v[3];
      for (size_t c = 0; c < 3; ++c) v[c] = &mesh.vertices[mesh.indices[k + c]];
      const glm::vec3 face =
          glm::cross(v[1]->position - v[0]->position, v[2]->position - v[0]->position);
      for (const Vertex* vertex : v) disagree += glm::dot(face, vertex->normal) <= 0.0f;
      corners += 3;
    }
    // Where a coarse mesh cuts a tight curve, a corner may stand beyond a right angle.
    EXPECT_LE(double(disagree), 0.01 * double(corners)) << mesh.name;
  }
}

TEST_P(EveryBuiltin, HasNoNeedlessBulk) {
  for (const Texture& texture : make(GetParam()).textures) {
    EXPECT_LE(texture.width, 512u);
    EXPECT_LE(texture.height, 512u);
    EXPECT_EQ(texture.rgba.size(), size_t{texture.width} * texture.height * 4);
  }
}

TEST_P(EveryBuiltin, LoopsInTenSeconds) {
  const Scene scene = make(GetParam());
  ASSERT_GE(scene.animation.size(), 3u);  // the camera's two channels and something else
  EXPECT_EQ(scene.animation[0].node, scene.cameras[0].node);
  for (const AnimationChannel& channel : scene.animation) {
    ASSERT_EQ(channel.times_s.size(), channel.values.size());
    EXPECT_EQ(channel.times_s.front(), 0.0f);
    EXPECT_EQ(channel.times_s.back(), 10.0f);
    EXPECT_TRUE(std::is_sorted(channel.times_s.begin(), channel.times_s.end()));
    const glm::vec4 first = channel.values.front(), last = channel.values.back();
    if (channel.path == AnimationPath::rotation) {
      EXPECT_NEAR(std::abs(glm::dot(first, last)), 1.0f, 1e-5f);  // q and -q turn the same way
      for (const glm::vec4& q : channel.values) EXPECT_NEAR(glm::length(q), 1.0f, 1e-5f);
    } else {
      EXPECT_EQ(first, last);
    }
  }
}

TEST_P(EveryBuiltin, CamerasSeeSomethingAtArmsLength) {
  const Scene scene = make(GetParam());
  ASSERT_FALSE(scene.cameras.empty());
  for (float time_s = 0.0f; time_s < 10.0f; time_s += 2.5f) {
    const std::vector<glm::mat4> world = pose(scene, time_s);
    for (const Camera& camera : scene.cameras) {
      const glm::vec3 eye = world[camera.node][3];
      const float distance = ray_distance(scene, world, eye, -glm::vec3(world[camera.node][2]));
      EXPECT_GT(distance, 0.5f) << camera.name << " at " << time_s << " s";
      EXPECT_LT(distance, 30.0f) << camera.name << " at " << time_s << " s";
    }
  }
}

TEST_P(EveryBuiltin, LightsReachSomething) {
  const Scene scene = make(GetParam());
  ASSERT_FALSE(scene.lights.empty());
  ASSERT_TRUE(scene.exposure_ev.has_value());
  const std::vector<glm::mat4> world = pose(scene, 0.0f);
  for (const Light& light : scene.lights) {
    const glm::vec3 from = world[light.node][3];
    const float distance = ray_distance(scene, world, from, -glm::vec3(world[light.node][2]));
    ASSERT_TRUE(std::isfinite(distance)) << light.name;

    // A surface of albedo 0.75 there shows between middle grey and one stop above white.
    const float lux = light.kind == LightKind::directional
                          ? light.intensity
                          : light.intensity / (distance * distance);
    const float shown = 0.75f * lux / 3.14159265f * std::exp2(*scene.exposure_ev);
    EXPECT_GT(shown, 0.5f) << light.name;
    EXPECT_LT(shown, 2.0f) << light.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Builtin, EveryBuiltin,
                         testing::Values("atrium", "atrium:triangles=10000", "basket", "cornell",
                                         "divider-room", "dominoes", "floating-object", "graveyard",
                                         "spot-floor", "still-life", "table", "three-lights"),
                         [](const auto& instance) {
                           std::string name;
                           for (const char c : instance.param) name += std::isalnum(c) ? c : '_';
                           return name;
                         });

TEST(BuiltinSpec, NamesWhatIsValid) {
  const std::map<std::string, std::string> expected = {
      {"sponza",
       "atrium, basket, cornell, divider-room, dominoes, floating-object, graveyard, spot-floor, "
       "still-life, table, three-lights"},
      {"",
       "atrium, basket, cornell, divider-room, dominoes, floating-object, graveyard, spot-floor, "
       "still-life, table, three-lights"},
      {"atrium:size=3", "triangles=N and object=FILE"},
      {"cornell:object=a.glb", "these have: divider-room, floating-object"},
      {"atrium:triangles=20000,object=a.glb", "'atrium' has no object"},
      {"divider-room:object=", "needs the name of a file"},
      {"divider-room:triangles=20000", "'divider-room' has no parameter"},
      {"atrium:", "triangles=N"},
      {"atrium:triangles=many", "10000 to 1000000"},
      {"atrium:triangles=", "10000 to 1000000"},
      {"atrium:triangles=-20000", "10000 to 1000000"},
      {"atrium:triangles=20000x", "10000 to 1000000"},
      {"atrium:triangles=99999999999", "10000 to 1000000"},
      {"atrium:triangles=9999", "10000 to 1000000"},
      {"atrium:triangles=1000001", "10000 to 1000000"},
      {"cornell:triangles=20000", "'cornell' has no parameter"},
      {"spot-floor:triangles=20000", "'spot-floor' has no parameter"},
  };
  for (const auto& [spec, text] : expected) {
    const Result<Scene> scene = make_builtin_scene(spec);
    ASSERT_FALSE(scene.ok()) << spec;
    EXPECT_EQ(scene.error().kind, ErrorKind::usage) << spec;
    EXPECT_NE(scene.error().message.find(text), std::string::npos) << scene.error().message;
    EXPECT_EQ(scene.error().message.find('\n'), std::string::npos);
  }
}

}  // namespace
}  // namespace lueur
