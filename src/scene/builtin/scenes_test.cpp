// SPDX-License-Identifier: MIT
// What each built-in scene is made to show.
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "scene/builtin/builtin_fixture.h"

namespace lueur {
namespace {

TEST(Atrium, MeetsTheTriangleCount) {
  for (const uint32_t triangles : {10'000u, 12'345u, 40'000u, 100'000u, 1'000'000u}) {
    const Result<Scene> scene = make_builtin_scene("atrium", {triangles});
    ASSERT_TRUE(scene.ok());
    EXPECT_NEAR(double(triangle_count(*scene)), triangles, 0.1 * triangles);
  }
}

TEST(Atrium, HasThreeCamerasAndDrapesOfThreeColors) {
  const Scene scene = make("atrium");
  EXPECT_EQ(scene.cameras.size(), 3u);
  for (int channel = 0; channel < 3; ++channel) {
    const bool found =
        std::any_of(scene.materials.begin(), scene.materials.end(), [&](const Material& m) {
          const glm::vec4 c = m.base_color;
          return m.name.ends_with("cloth") && c[channel] > 4 * c[(channel + 1) % 3] &&
                 c[channel] > 4 * c[(channel + 2) % 3];
        });
    EXPECT_TRUE(found) << "channel " << channel;
  }
}

TEST(Atrium, LetsNoSunInFromOutside) {
  // From any place under a gallery, the way to the sun must be barred or lead through the court's
  // open roof, not through a wall, floor or ceiling.
  const Scene scene = make("atrium:triangles=20000");
  const std::vector<glm::mat4> world = pose(scene, 0.0f);
  const glm::vec3 to_sun = glm::normalize(glm::vec3(world[scene.lights[0].node][2]));
  for (float x = -11.3f; x < 11.5f; x += 1.13f) {
    for (const float z : {-6.5f, -5.1f, 5.1f, 6.5f}) {
      for (const float y : {0.3f, 4.2f, 5.5f, 8.8f}) {
        const glm::vec3 from(x, y, z);
        if (std::isfinite(ray_distance(scene, world, from, to_sun))) continue;
        const glm::vec3 at_roof = from + to_sun * ((9.45f - y) / to_sun.y);
        EXPECT_LT(std::abs(at_roof.z), 3.2f) << x << ' ' << y << ' ' << z;
      }
    }
  }
}

TEST(Cornell, HasTheMeasuredReflectancesAndSize) {
  const Scene scene = make("cornell");
  std::map<std::string, glm::vec4> color;
  for (const Material& m : scene.materials) color[m.name] = m.base_color;

  // Near-constant spectra stay near their value: white about 0.74 and grey, the red wall's about
  // 0.06 below 560 nm and 0.63 above 620 nm, the green wall's about 0.1 at both ends.
  EXPECT_NEAR(color["white"].g, 0.736f, 0.01f);
  EXPECT_NEAR(color["white"].r, color["white"].b, 0.01f);
  EXPECT_LT(color["red"].g, 0.07f);
  EXPECT_GT(color["red"].r, 0.4f);
  EXPECT_LT(color["red"].r, 0.63f);
  EXPECT_GT(color["green"].g, 0.35f);
  EXPECT_LT(color["green"].g, 0.481f);  // no more than the spectrum's peak
  EXPECT_LT(std::max(color["green"].r, color["green"].b), 0.1f);

  // From the middle of the opening to the back wall is 5.592 m, floor to ceiling 5.488 m.
  const std::vector<glm::mat4> world = pose(scene, 0.0f);
  EXPECT_NEAR(ray_distance(scene, world, {2.78f, 5.0f, 0}, {0, 0, 1}), 5.592f, 1e-3f);
  EXPECT_NEAR(ray_distance(scene, world, {2.78f, 0.5f, 0.3f}, {0, -1, 0}), 0.5f, 1e-3f);
  EXPECT_NEAR(ray_distance(scene, world, {2.78f, 0.5f, 0.3f}, {0, 1, 0}), 4.988f, 1e-3f);
}

TEST(Cornell, PanelGlowsWithATwentiethOfTheLampsFlux) {
  const Scene scene = make("cornell");
  const Light& light = scene.lights[0];
  const auto panel = std::find_if(scene.materials.begin(), scene.materials.end(),
                                  [](const Material& m) { return m.emission != glm::vec3(0.0f); });
  ASSERT_NE(panel, scene.materials.end());
  EXPECT_LT(glm::distance(panel->emission / panel->emission.x, light.color), 1e-5f);

  // Integrate the spot over its cone, ring by ring.
  double flux = 0.0;
  const int rings = 20'000;
  const double c0 = std::cos(double(light.outer_cone_rad));
  for (int k = 0; k < rings; ++k) {
    const double c = c0 + (1 - c0) * (k + 0.5) / rings, falloff = (c - c0) / (1 - c0);
    flux += 2 * 3.14159265358979 * light.intensity * falloff * falloff * (1 - c0) / rings;
  }
  EXPECT_NEAR(flux, 20 * 3.14159265358979 * panel->emission.x * 1.30 * 1.05, 1e-3 * flux);
}

TEST(Dominoes, HasFewTriangles) {
  EXPECT_NEAR(double(triangle_count(make("dominoes"))), 1'400, 140);
}

TEST(Dominoes, StonesNeverRunIntoEachOther) {
  // While stones fall, no corner of one gets into the body of the next. They stand on a bend, so
  // that a leaning stone's edges reach a little further than the row's own line: 2 cm are allowed.
  const Scene scene = make("dominoes");
  std::vector<MeshInstance> stones;
  for (const MeshInstance& instance : scene.instances)
    if (scene.meshes[instance.mesh].name.starts_with("stone")) stones.push_back(instance);
  ASSERT_EQ(stones.size(), 28u);
  for (float time_s = 0.0f; time_s < 10.0f; time_s += 0.37f) {
    const std::vector<glm::mat4> world = pose(scene, time_s);
    for (size_t k = 0; k + 1 < stones.size(); ++k) {
      const glm::mat4 next_from_this =
          glm::inverse(world[stones[k + 1].node]) * world[stones[k].node];
      for (const Vertex& v : scene.meshes[stones[k].mesh].vertices) {
        const glm::vec3 p = next_from_this * glm::vec4(v.position, 1);
        const float inside = std::min({0.25f - std::abs(p.x), p.y, 1.0f - p.y, p.z + 0.17f, -p.z});
        EXPECT_LT(inside, 0.02f) << k << " at " << time_s << " s";
      }
    }
  }
}

TEST(Graveyard, HasAsManyTrianglesAsItsPaperSays) {
  EXPECT_NEAR(double(triangle_count(make("graveyard"))), 120'000, 12'000);
}

TEST(SpotFloor, LightsNothingButTheFloor) {
  // Rays within the cone meet the floor first, wherever the light stands in its loop.
  const Scene scene = make("spot-floor");
  const Light& spot = scene.lights[0];
  for (const float time_s : {0.0f, 2.5f, 7.5f}) {
    const std::vector<glm::mat4> world = pose(scene, time_s);
    const glm::vec3 from = world[spot.node][3];
    for (int k = 0; k < 16; ++k) {
      const float turn = 6.2831853f * float(k) / 16.0f, radius = std::tan(spot.outer_cone_rad);
      const glm::vec3 direction(radius * std::cos(turn), -1.0f, radius * std::sin(turn));
      EXPECT_NEAR(ray_distance(scene, world, from, direction), from.y, 1e-3f) << k;
    }
  }
}

TEST(Builtin, HaveThePapersTriangleCountsAndThoseOfTheirSummaries) {
  const auto object_triangles = [](const Scene& scene) {
    size_t most = 0;
    for (const Mesh& mesh : scene.meshes) most = std::max(most, mesh.indices.size() / 3);
    return double(most);
  };
  const Scene divider = make("divider-room"), floating = make("floating-object");
  EXPECT_GE(object_triangles(divider), 50e3);
  EXPECT_LE(object_triangles(divider), 70e3);
  EXPECT_NEAR(object_triangles(floating), 69e3, 0.03 * 69e3);
  EXPECT_NEAR(double(triangle_count(floating)), 70e3, 0.03 * 70e3);
  EXPECT_NEAR(double(triangle_count(divider)), 70e3, 0.03 * 70e3);
  EXPECT_NEAR(double(triangle_count(make("basket"))), 91e3, 1e3);
  EXPECT_NEAR(double(triangle_count(make("table"))), 58e3, 1e3);
}

TEST(Basket, ShowsItsLitSideToTheSideCameraOnly) {
  // What the hidden lamp's rays meet first is in plain view of `side`, and never of `front`.
  const Scene& scene = make("basket");
  ASSERT_EQ(scene.cameras.size(), 2u);
  ASSERT_EQ(scene.cameras[1].name, "side");
  const Light& lamp = scene.lights[0];
  int seen = 0, count = 0;
  for (const float time_s : {0.0f, 2.5f, 7.5f}) {
    const std::vector<glm::mat4> world = pose(scene, time_s);
    const glm::vec3 from = world[lamp.node][3];
    for (int k = 0; k < 24; ++k) {
      const float turn = 2.399963f * float(k);
      const float reach = std::tan(lamp.outer_cone_rad) * std::sqrt((float(k) + 0.5f) / 24.0f);
      const glm::vec3 direction =
          glm::normalize(glm::mat3(world[lamp.node]) *
                         glm::vec3(reach * std::cos(turn), reach * std::sin(turn), -1.0f));
      const float distance = ray_distance(scene, world, from, direction);
      ASSERT_LT(distance, 1.4f) << k;  // the basket or its leaves, not the room beyond
      const glm::vec3 lit = from + direction * (distance - 1e-3f);
      const auto sees = [&](const Camera& camera) {
        const glm::vec3 way = lit - glm::vec3(world[camera.node][3]);
        return ray_distance(scene, world, world[camera.node][3], glm::normalize(way)) >
               glm::length(way) - 5e-3f;
      };
      EXPECT_FALSE(sees(scene.cameras[0])) << k << " at " << time_s << " s";
      seen += sees(scene.cameras[1]);
      ++count;
    }
  }
  EXPECT_GT(seen, count / 2);  // the far half of a round side turns away from it
}

TEST(Table, GetsItsLightFromTheWallOnly) {
  // Wherever the sun stands in its loop, its rays end outside, on the window's frame, or on the
  // wall across from it.
  const Scene& scene = make("table");
  ASSERT_EQ(scene.lights.size(), 1u);
  for (const float time_s : {0.0f, 2.5f, 7.5f}) {
    const std::vector<glm::mat4> world = pose(scene, time_s);
    const glm::vec3 along = -glm::vec3(world[scene.lights[0].node][2]);
    int on_wall = 0;
    for (float y = 0.05f; y < 2.75f; y += 0.11f) {
      for (float z = -2.05f; z < 3.15f; z += 0.13f) {
        const glm::vec3 from = glm::vec3(2.5f, y, z) - 2.0f * along;
        const glm::vec3 met = from + along * ray_distance(scene, world, from, along);
        if (met.x > 2.5f) continue;
        EXPECT_NEAR(met.x, -2.3f, 1e-3f) << y << ' ' << z << " at " << time_s << " s";
        ++on_wall;
      }
    }
    EXPECT_GT(on_wall, 100);
  }
}

TEST(ThreeLights, HasOneOfEachKindAndSunOnAPatch) {
  const Scene scene = make("three-lights");
  std::set<LightKind> kinds;
  for (const Light& light : scene.lights) kinds.insert(light.kind);
  EXPECT_EQ(kinds.size(), 3u);
  EXPECT_EQ(scene.lights.size(), 3u);
  // The opening has 1.4 x 4.4 m, some of which its own thickness shades; the floor 10 x 9.5 m.
  const std::vector<glm::mat4> world = pose(scene, 0.0f);
  const glm::vec3 to_sun = world[scene.lights[0].node][2];
  constexpr int kSteps = 40;
  int lit = 0;
  for (int k = 0; k < kSteps * kSteps; ++k) {
    const glm::vec2 share = (glm::vec2(k % kSteps, k / kSteps) + 0.5f) / float(kSteps);
    const glm::vec3 floor(-5.0f + 10.0f * share.x, 1e-3f, -4.0f + 9.5f * share.y);
    lit += std::isinf(ray_distance(scene, world, floor, to_sun));
  }
  const float area = 95.0f * float(lit) / float(kSteps * kSteps);
  EXPECT_GT(area, 4.0f);
  EXPECT_LT(area, 6.2f);
}

TEST(StillLife, HasAsManyTrianglesAsItsPaperSays) {
  EXPECT_NEAR(double(triangle_count(make("still-life"))), 202'000, 20'200);
}

TEST(StillLife, SkullIsHollowAndOpenOnlyWhereItShouldBe) {
  // From the middle of the head, both eyes look out; bone bars every way up, back and sideways.
  const Scene scene = make("still-life");
  const std::vector<glm::mat4> world = pose(scene, 0.0f);
  Scene alone = scene;
  std::erase_if(alone.instances, [&](const MeshInstance& instance) {
    return scene.meshes[instance.mesh].name != "skull";
  });
  ASSERT_EQ(alone.instances.size(), 1u);
  const glm::mat4 world_from_skull = world[alone.instances[0].node];
  const auto way_out = [&](glm::vec3 from, glm::vec3 to) {
    const glm::vec3 a = world_from_skull * glm::vec4(from, 1);
    const glm::vec3 b = world_from_skull * glm::vec4(to, 1);
    return !std::isfinite(ray_distance(alone, world, a, glm::normalize(b - a)));
  };
  for (const float side : {-1.0f, 1.0f})
    EXPECT_TRUE(way_out({0.2f * side, 0.88f, 0.2f}, {0.29f * side, 0.82f, 1.0f})) << side;
  const glm::vec3 middle{0, 1.1f, -0.2f};
  for (int k = 0; k < 64; ++k) {
    const float turn = 2.4f * float(k), height = 1.0f - float(k) / 64.0f;  // the upper half
    const float r = std::sqrt(1.0f - height * height);
    EXPECT_FALSE(
        way_out(middle, middle + glm::vec3(r * std::cos(turn), height, r * std::sin(turn))))
        << k;
  }
}

TEST(StillLife, FirstCameraSeesNoLetter) {
  // No corner of a letter comes into a picture of up to 16:9, at any time.
  const Scene scene = make("still-life");
  for (float time_s = 0.0f; time_s < 10.0f; time_s += 0.5f) {
    const std::vector<glm::mat4> world = pose(scene, time_s);
    const Camera& camera = scene.cameras[0];
    const glm::mat4 view_from_world = glm::inverse(world_from_camera(world[camera.node]));
    const float half_height = std::tan(0.5f * camera.vertical_fov_rad);
    size_t corners = 0;
    for (const MeshInstance& instance : scene.instances) {
      const Mesh& mesh = scene.meshes[instance.mesh];
      if (mesh.name.find("letter") == std::string::npos) continue;
      for (const Vertex& v : mesh.vertices) {
        const glm::vec3 p = view_from_world * world[instance.node] * glm::vec4(v.position, 1);
        ++corners;
        if (p.z >= 0.0f) continue;
        const glm::vec2 at = glm::vec2(p) / (-p.z * half_height);
        EXPECT_TRUE(std::abs(at.y) > 1.0f || std::abs(at.x) > 16.0f / 9.0f)
            << mesh.name << " at " << time_s << " s";
      }
    }
    EXPECT_GT(corners, 1'000u);
  }
}

}  // namespace
}  // namespace lueur
