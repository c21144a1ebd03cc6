// SPDX-License-Identifier: MIT
// The G-buffer and the composition against what follows from the scene.
#include "renderer/renderer.h"

#include <cmath>

#include "image/half.h"
#include "renderer/renderer_fixture.h"
#include "scene/builtin/scene_builder.h"
#include "shading/packing.h"

namespace lueur {
namespace {

constexpr float kNothing = 0.0f;  // depth where nothing is

class SurfaceTest : public RendererTest {
 protected:
  // A vertical square around `centre` that faces +z.
  static int32_t screen(Scene& scene, const glm::vec3& centre, float half_side,
                        int32_t material = 0) {
    return add_quad(scene, centre - glm::vec3(half_side, half_side, 0), {2 * half_side, 0, 0},
                    {0, 2 * half_side, 0}, material);
  }
  // A camera at z = 3 that looks at the origin.
  static Scene frontal() { return scene_seen_from({0, 0, 3}, {0, 0, 0}); }
  glm::vec3 normal_at(const PixelRay& ray) const {
    const glm::vec4 packed = at("normal", ray);
    return octahedral_decode({packed.x, packed.y});
  }
};

TEST_F(SurfaceTest, DepthIsNearOverDistanceAlongTheAxis) {
  Scene scene = frontal();
  // Tilted, so that distance and depth differ from pixel to pixel.
  const glm::vec3 normal = glm::normalize(glm::vec3(0.4f, 0.3f, 1));
  const glm::vec3 u = glm::normalize(glm::cross(glm::vec3(0, 1, 0), normal));
  const glm::vec3 v = glm::cross(normal, u);
  add_quad(scene, -0.8f * (u + v), 1.6f * u, 1.6f * v);
  scene.cameras[0].near_m = 0.1f;
  render(scene, {.extent = {61, 47}});
  int seen = 0, nothing = 0;
  for (const PixelRay& ray : rays()) {
    const glm::dvec3 p = *meet_plane(ray, {}, normal);
    const double along_u = std::abs(glm::dot(p, glm::dvec3(u)));
    const double along_v = std::abs(glm::dot(p, glm::dvec3(v)));
    const float depth = at("depth", ray).x;
    if (std::max(along_u, along_v) < 0.78) {
      const double z = 3.0 - p.z;
      ASSERT_NEAR(static_cast<double>(depth), 0.1 / z, 1e-5 * 0.1 / z);
      ASSERT_GT(glm::dot(normal_at(ray), normal), 1 - 1e-6f);
      ++seen;
    } else if (std::max(along_u, along_v) > 0.82) {
      ASSERT_EQ(depth, kNothing);
      ASSERT_EQ(at("source", ray), glm::vec4(0, 0, 0, 0));
      ++nothing;
    }
  }
  EXPECT_GT(seen, 500);
  EXPECT_GT(nothing, 500);
}

TEST_F(SurfaceTest, NearerSurfacesHideFartherOnesInAnyOrder) {
  for (const bool near_first : {true, false}) {
    Scene scene = frontal();
    screen(scene, {0, 0, near_first ? 1.0f : 0.0f}, 1.0f);
    screen(scene, {0, 0, near_first ? 0.0f : 1.0f}, 1.0f);
    render(scene);
    const PixelRay middle = rays()[24 * 64 + 32];
    EXPECT_NEAR(at("depth", middle).x, scene.cameras[0].near_m / 2.0f, 1e-6f);
  }
}

TEST_F(SurfaceTest, NormalsFollowNonUniformScale) {
  Scene scene = frontal();
  const glm::vec3 u(1, 0, 0), v = glm::vec3(0, 1, -1);
  const int32_t node = add_quad(scene, -0.5f * (u + v), u, v);
  scene.nodes[static_cast<size_t>(node)].scale = {1, 1, 3};
  render(scene);
  // The plane y + z = 0 becomes y + z / 3 = 0.
  const glm::vec3 exact = glm::normalize(glm::vec3(0, 1, 1.0f / 3));
  EXPECT_GT(glm::dot(normal_at(rays()[24 * 64 + 32]), exact), 1 - 1e-6f);
}

TEST_F(SurfaceTest, EmissionIsSourceAndNotSpecular) {
  Scene scene = frontal();
  const int32_t lamp = builtin::add_material(scene, "lamp", glm::vec3(0.5f), 1.0f);
  scene.materials[static_cast<size_t>(lamp)].emission = {4.0f, 0.5f, 100'000.0f};
  screen(scene, {0, 0, 0}, 2.0f, lamp);
  render(scene);
  for (const PixelRay& ray : rays()) {
    // Half floats end at 65504.
    ASSERT_EQ(glm::vec3(at("source", ray)), glm::vec3(4.0f, 0.5f, 65504.0f));
    ASSERT_EQ(glm::vec3(at("emission", ray)), glm::vec3(4.0f, 0.5f, 65504.0f));
    ASSERT_EQ(glm::vec3(at("specular", ray)), glm::vec3(0.0f));
  }
}

TEST_F(SurfaceTest, MetalHasNoDiffuseLight) {
  Scene scene = frontal();
  const int32_t metal = builtin::add_material(scene, "metal", glm::vec3(0.9f, 0.6f, 0.2f), 0.5f);
  scene.materials[static_cast<size_t>(metal)].metallic = 1.0f;
  screen(scene, {0, 0, 0}, 2.0f, metal);
  add_light(scene, LightKind::directional, 100.0f, {}, {0, 0, -1});
  render(scene, {.extent = {33, 33}});
  const PixelRay middle = rays()[16 * 33 + 16];
  EXPECT_EQ(glm::vec3(at("source", middle)), glm::vec3(0.0f));
  EXPECT_EQ(glm::vec3(at("albedo", middle)), glm::vec3(0.0f));
  EXPECT_NEAR(at("material", middle).x, 1.0f, 1e-6f);
  EXPECT_NEAR(at("material", middle).y, 0.5f, 0.51f / 255);
  // Light, eye and normal in one line: GGX's D = 1 / (pi alpha^2), V = 1/4, F = base colour.
  const double alpha = std::pow(static_cast<double>(at("material", middle).y), 2);
  const glm::vec4 specular = at("specular", middle);
  for (int c = 0; c < 3; ++c) {
    const double exact =
        static_cast<double>(scene.materials[1].base_color[c]) * 100.0 / (4 * kPi * alpha * alpha);
    // 8 bits of sRGB hold the base colour: at most half a step, about 1 % at 0.2.
    EXPECT_NEAR(specular[c], exact, 0.012 * exact) << c;
  }
}

// One quad, its node mirrored, looks the same as an unmirrored one.
TEST_F(SurfaceTest, MirroredInstancesAreSeenAndLitFromTheFront) {
  for (const glm::vec3 scale : {glm::vec3(-1, 1, 1), glm::vec3(1, -1, 1), glm::vec3(-1, -1, 1)}) {
    Scene scene = frontal();
    const int32_t node = screen(scene, {0, 0, 0}, 0.8f);
    scene.nodes[static_cast<size_t>(node)].scale = scale;
    // An instance that is not mirrored shares the mesh.
    builtin::add_instance(scene, 0, builtin::add_node(scene, "plain", {0, 0, -1}));
    add_light(scene, LightKind::directional, 10.0f, {}, {0, 0, -1});
    render(scene, {.extent = {33, 33}});
    const PixelRay middle = rays()[16 * 33 + 16];
    EXPECT_NEAR(at("depth", middle).x, scene.cameras[0].near_m / 3.0f, 1e-6f);
    EXPECT_GT(normal_at(middle).z, 1 - 1e-6f);
    EXPECT_NEAR(luminance_at("source", middle), 10.0 / kPi, kHalfError * 10.0 / kPi);
  }
  // Mirrored along z its front looks away.
  Scene scene = frontal();
  const int32_t node = screen(scene, {0, 0, 0}, 0.8f);
  scene.nodes[static_cast<size_t>(node)].scale = {1, 1, -1};
  render(scene, {.extent = {33, 33}});
  EXPECT_EQ(at("depth", rays()[16 * 33 + 16]).x, kNothing);
}

TEST_F(SurfaceTest, BackFacesAreCulledUnlessDoubleSided) {
  for (const bool double_sided : {false, true}) {
    Scene scene = frontal();
    scene.materials[0].double_sided = double_sided;
    const int32_t node = screen(scene, {0, 0, 0}, 0.8f);
    scene.nodes[static_cast<size_t>(node)].rotation =
        glm::angleAxis(static_cast<float>(kPi), glm::vec3(0, 1, 0));
    add_light(scene, LightKind::directional, 10.0f, {}, {0, 0, -1});
    render(scene, {.extent = {33, 33}});
    const PixelRay middle = rays()[16 * 33 + 16];
    if (!double_sided) {
      EXPECT_EQ(at("depth", middle).x, kNothing);
      continue;
    }
    // Seen and lit on the side that the camera looks at.
    EXPECT_GT(at("depth", middle).x, 0.0f);
    EXPECT_GT(normal_at(middle).z, 1 - 1e-6f);
    EXPECT_NEAR(luminance_at("source", middle), 10.0 / kPi, kHalfError * 10.0 / kPi);
  }
}

AnimationChannel moves(int32_t node, const glm::vec3& from, const glm::vec3& to) {
  AnimationChannel channel;
  channel.node = node;
  channel.times_s = {0.0f, 1.0f};
  channel.values = {glm::vec4(from, 0), glm::vec4(to, 0)};
  return channel;
}

// Where a point stands in the image, in UV.
glm::dvec2 project(const glm::dmat4& world_from_camera, const glm::dvec3& point, double fov_rad,
                   Extent extent) {
  const glm::dvec3 p(glm::inverse(world_from_camera) * glm::dvec4(point, 1.0));
  const double tan_v = std::tan(0.5 * fov_rad), tan_h = tan_v * extent.width / extent.height;
  return {0.5 + 0.5 * p.x / (-p.z * tan_h), 0.5 - 0.5 * p.y / (-p.z * tan_v)};
}

TEST_F(SurfaceTest, MotionIsTheDifferenceOfTwoProjections) {
  Scene scene = frontal();
  const int32_t node = screen(scene, {0, 0, 0}, 5.0f);
  scene.animation.push_back(moves(scene.cameras[0].node, {0, 0, 3}, {0.4f, 0.2f, 2.5f}));
  scene.animation.push_back(moves(node, {0, 0, 0}, {-0.3f, 0.5f, -0.4f}));
  AnimationChannel turn;
  turn.node = node;
  turn.path = AnimationPath::rotation;
  turn.times_s = {0.0f, 1.0f};
  turn.values = {{0, 0, 0, 1}, {0, std::sin(0.25f), 0, std::cos(0.25f)}};
  scene.animation.push_back(turn);

  const Shot shot{.extent = kExtent, .time_s = 0.75f, .previous_time_s = 0.5f};
  render(scene, shot);
  const auto now = pose(scene, shot.time_s), before = pose(scene, shot.previous_time_s);
  const auto quad = static_cast<size_t>(node);
  const glm::dmat4 quad_now(now[quad]), quad_before(before[quad]);
  const double fov = static_cast<double>(scene.cameras[0].vertical_fov_rad);
  int compared = 0;
  for (const PixelRay& ray : rays()) {
    const auto p = meet_plane(ray, glm::dvec3(quad_now[3]), glm::dvec3(quad_now[2]));
    ASSERT_TRUE(p);
    const glm::dvec3 p_before(quad_before * glm::inverse(quad_now) * glm::dvec4(*p, 1.0));
    const glm::dvec2 exact = project(glm::dmat4(now[0]), *p, fov, kExtent) -
                             project(glm::dmat4(before[0]), p_before, fov, kExtent);
    const glm::vec4 motion = at("motion", ray);
    ASSERT_NEAR(static_cast<double>(motion.x), exact.x, 1e-3 * std::abs(exact.x) + 1e-6);
    ASSERT_NEAR(static_cast<double>(motion.y), exact.y, 1e-3 * std::abs(exact.y) + 1e-6);
    compared += glm::length(exact) > 0.01;
  }
  EXPECT_GT(compared, 1000);
}

TEST_F(SurfaceTest, NothingMovesWithoutTime) {
  Scene scene = frontal();
  screen(scene, {0, 0, 0}, 2.0f);
  scene.animation.push_back(moves(0, {0, 0, 3}, {1, 0, 3}));
  render(scene, {.extent = kExtent, .time_s = 0.5f, .previous_time_s = 0.5f});
  for (const PixelRay& ray : rays()) ASSERT_EQ(at("motion", ray), glm::vec4(0.0f));
}

// A technique that gives what it was told to.
class GivenLight final : public Technique {
 public:
  Outputs render(Frame& frame, const Inputs& inputs) override {
    const Extent extent = inputs.g_buffer.depth.extent;
    std::vector<uint16_t> halves;
    for (size_t i = 0; i < size_t{extent.width} * extent.height; ++i)
      for (size_t c = 0; c < 4; ++c) halves.push_back(half_from_float(value(i, c)));
    std::vector<uint16_t> open;
    for (size_t i = 0; i < size_t{extent.width} * extent.height; ++i)
      open.push_back(half_from_float(open_share(i)));
    Outputs outputs;
    if (gives_diffuse)
      outputs.diffuse =
          frame.recorder().upload_image("given", extent, Format::rgba16f, halves.data());
    if (gives_occlusion)
      outputs.occlusion =
          frame.recorder().upload_image("given_occlusion", extent, Format::r16f, open.data());
    if (gives_specular)
      outputs.specular =
          frame.recorder().upload_image("given_specular", extent, Format::rgba16f, halves.data());
    return outputs;
  }
  void* settings() override { return nullptr; }
  bool gives_diffuse = true;
  bool gives_specular = false;
  bool gives_occlusion = false;
  static float open_share(size_t pixel) { return static_cast<float>(pixel % 17) / 16.0f; }
  static float value(size_t pixel, size_t channel) {
    return static_cast<float>((pixel * 7 + channel * 3) % 31) / 8.0f;
  }
};

TEST_F(SurfaceTest, ThePictureIsSourcePlusAlbedoTimesIndirectPlusSpecular) {
  Scene scene = frontal();
  const int32_t gloss = builtin::add_material(scene, "gloss", glm::vec3(0.7f, 0.3f, 0.1f), 0.4f);
  scene.materials.back().emission = {0.25f, 0, 0};
  screen(scene, {0, 0, 0}, 0.9f, gloss);
  add_light(scene, LightKind::point, 5.0f, {0.5f, 0.5f, 1.0f});
  GivenLight technique, with_specular, with_occlusion;
  with_specular.gives_specular = true;
  with_occlusion.gives_occlusion = true;  // of which the picture takes no notice
  for (GivenLight* used :
       {static_cast<GivenLight*>(nullptr), &technique, &with_specular, &with_occlusion}) {
    render(scene, {.extent = kExtent}, used);
    double brightest_specular = 0;
    for (const PixelRay& ray : rays()) {
      const glm::vec4 source = at("source", ray), specular = at("specular", ray);
      const glm::vec4 albedo = at("albedo", ray), composed = at("composed", ray);
      brightest_specular = std::max(brightest_specular, static_cast<double>(specular.y));
      for (int c = 0; c < 3; ++c) {
        const float indirect = used ? GivenLight::value(ray.index, static_cast<size_t>(c)) : 0.0f;
        if (used) {
          ASSERT_EQ(at("indirect", ray)[c], indirect);
        }
        float exact = source[c] + albedo[c] * indirect + specular[c];
        if (used && used->gives_specular) {
          ASSERT_EQ(at("indirect_specular", ray)[c], indirect);
          exact += indirect;
        }
        ASSERT_NEAR(composed[c], exact, exact / 1024) << ray.x << ", " << ray.y;
      }
    }
    EXPECT_GT(brightest_specular, 0.01);
  }
}

TEST_F(SurfaceTest, OcclusionWithoutLightDarkensWhatIsNotEmitted) {
  Scene scene = frontal();
  const int32_t gloss = builtin::add_material(scene, "gloss", glm::vec3(0.7f, 0.3f, 0.1f), 0.4f);
  scene.materials.back().emission = {0.25f, 0, 0};
  screen(scene, {0, 0, 0}, 0.9f, gloss);
  add_light(scene, LightKind::point, 5.0f, {0.5f, 0.5f, 1.0f});
  GivenLight technique;
  technique.gives_diffuse = false;
  technique.gives_occlusion = true;
  render(scene, {.extent = kExtent}, &technique);
  float brightest = 0;
  for (const PixelRay& ray : rays()) {
    const float open = GivenLight::open_share(ray.index);
    ASSERT_EQ(at("occlusion", ray).x, open);
    const glm::vec4 source = at("source", ray), emission = at("emission", ray);
    for (int c = 0; c < 3; ++c) {
      const float reflected = source[c] - emission[c];
      brightest = std::max(brightest, reflected);
      const float exact = emission[c] + open * reflected + at("specular", ray)[c];
      ASSERT_NEAR(at("composed", ray)[c], exact, exact / 1024) << ray.x << ", " << ray.y;
    }
  }
  EXPECT_GT(brightest, 0.01f);
}

TEST_F(SurfaceTest, EmptyScenesAndSinglePixelsWork) {
  Scene scene = frontal();
  add_light(scene, LightKind::point, 5.0f, {0, 1, 0});
  add_light(scene, LightKind::directional, 5.0f, {});
  render(scene, {.extent = {1, 1}});
  EXPECT_EQ(at("composed", rays()[0]), glm::vec4(0.0f));
  screen(scene, {0, 0, 0}, 1.0f);
  render(scene, {.extent = {1, 1}});
  EXPECT_GT(at("depth", rays()[0]).x, 0.0f);
}

TEST_F(SurfaceTest, TooLargeAPictureIsAUsageError) {
  Scene scene = frontal();
  screen(scene, {0, 0, 0}, 1.0f);
  auto renderer = Renderer::create(system(), context(), scene);
  ASSERT_TRUE(renderer.ok());
  const auto result = system().run([&](VkCommandBuffer commands) {
    Frame frame = context().record(commands);
    (*renderer)->record(frame, {.extent = {70'000, 2}}, nullptr);
    return frame.finish();
  });
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().kind, ErrorKind::usage);
  EXPECT_NE(result.error().message.find("70000x2"), std::string::npos) << result.error().message;
}

}  // namespace
}  // namespace lueur
