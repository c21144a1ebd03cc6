// SPDX-License-Identifier: MIT
// The reference's direct light against the rasterizer's, pixel by pixel. Both look through the same
// points at the same surfaces; a shadow map has a soft edge where rays have a sharp one, and its
// texels cut corners. So they may differ beside edges of shadows and surfaces, and nowhere else.
#include <algorithm>
#include <cmath>

#include "reference/reference.h"
#include "renderer/renderer.h"
#include "scene/builtin/builtin.h"
#include "scene/builtin/procedural_texture.h"
#include "scene/builtin/scene_builder.h"
#include "shading/packing.h"
#include "support/gpu_test.h"
#include "support/test_scene.h"

namespace lueur {
namespace {

constexpr Extent kExtent{320, 180};

// Panels that show what a file may bring along, each in its own way: the vertices' colours; a
// texture by the second coordinates, scaled, turned and moved; two joints, of which one turns; a
// morph target; no light at all on a surface that shows its colour.
Scene panels() {
  Scene scene = scene_seen_from({0, 0.4f, 2.6f}, {0, 0.4f, 0});
  const auto panel = [&](float x, int32_t material) -> Mesh& {
    add_quad(scene, {x, 0, 0}, {0.6f, 0, 0.1f}, {0, 0.8f, 0}, material);
    return scene.meshes.back();
  };
  Mesh& colored = panel(-1.75f, 0);
  colored.vertices[0].color = {65535, 9000, 3000, 65535};
  colored.vertices[2].color = {3000, 9000, 65535, 65535};

  scene.textures.push_back(builtin::make_color_texture("waves", 64, [](glm::vec2 uv) {
    return glm::vec3(0.5f) + 0.4f * glm::sin(glm::vec3(6.2831853f) * glm::vec3(uv, uv.x + uv.y));
  }));
  const int32_t placed = builtin::add_material(scene, "placed", glm::vec3(0.9f), 1.0f);
  TextureUse& use = scene.materials.back().base_color_texture;
  use.texture = 0;
  use.uv_set = 1;
  use.transform = glm::mat3x2(0.8f, -0.6f, 0.9f, 1.2f, 0.3f, 0.1f);
  for (Vertex& vertex : panel(-1.05f, placed).vertices) vertex.uv_2 = glm::vec2(1) - vertex.uv;

  Mesh& skinned = panel(0, 0);
  scene.instances.back().skin = 0;
  Skin skin;
  for (const float x : {-0.35f, 0.0f}) {
    skin.joints.push_back(builtin::add_node(scene, "joint", {x, 0, 0}));
    skin.joint_from_mesh.emplace_back(1.0f);
  }
  builtin::animate_rotation(scene, skin.joints[1], 4, [](float phase) {
    return glm::angleAxis(2.0f * phase, glm::vec3(0, 1, 0));
  });
  scene.skins.push_back(skin);
  for (uint16_t i = 0; i < 4; ++i)
    skinned.influences.push_back({glm::u16vec4(0, 1, 0, 0), {0.25f * i, 1.0f - 0.25f * i, 0, 0}});

  Mesh& morphed = panel(0.35f, placed);
  morphed.morph_targets.push_back({{{0, 0, 0}, {0, 0.2f, 0.04f}, {0.1f, 0, 0}, {0, 0, 0}}, {}, {}});
  scene.instances.back().morph_weights = {0.7f};

  builtin::add_material(scene, "unlit", {0.2f, 0.6f, 0.4f});
  scene.materials.back().unlit = true;
  panel(1.1f, static_cast<int32_t>(scene.materials.size()) - 1).vertices[1].color = {65535, 20000,
                                                                                     65535, 65535};
  add_light(scene, LightKind::point, 60.0f, {1, 2, 4}).range_m = 5.5f;
  return scene;
}

struct Case {
  const char* scene;
  // Share of the pixels that lie beside an edge and differ by more than 5 %: what the shadow maps
  // cost this scene. Twice what was seen, as drivers round their way around edges.
  double most_at_edges;
  Scene (*make)() = nullptr;  // none: the built-in scene of that name
  float time_s = 0.0f;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.scene;
}

class DirectLightTest : public GpuTest, public testing::WithParamInterface<Case> {
 protected:
  void SetUp() override {
    GpuTest::SetUp();
    const float time_s = GetParam().time_s;
    const Result<Scene> scene =
        GetParam().make ? GetParam().make() : make_builtin_scene(GetParam().scene);
    ASSERT_TRUE(scene.ok());
    near_m_ = scene->cameras[0].near_m;
    auto renderer = Renderer::create(system(), context(), *scene);
    ASSERT_TRUE(renderer.ok());
    run([&](Frame& frame) {
      const RenderedImages images =
          (*renderer)->record(frame, {.extent = kExtent, .time_s = time_s}, nullptr);
      for (const auto& [name, image] :
           {std::pair{"source", images.source}, std::pair{"specular", images.specular},
            std::pair{"albedo", images.albedo}, std::pair{"normal", images.normal},
            std::pair{"depth", images.depth}})
        frame.recorder().read_back(name, image);
    });
    auto truth = reference::render(
        *scene, {.width = kExtent.width, .height = kExtent.height, .time_s = time_s}, {.spp = 1});
    ASSERT_TRUE(truth.ok());
    truth_ = std::move(*truth);
  }

  const ImageF& truth(const char* layer) { return *find_layer(truth_, layer); }

  // Whether a square of 7 x 7 pixels around the pixel has both light and shade by the reference, or
  // two surfaces that meet: a map's texel and its filter cover that much of a picture of this size,
  // and at a crease they reach behind the other surface.
  bool beside_edge(uint32_t x, uint32_t y) {
    const ImageF &source = truth("source"), &emission = truth("emission"),
                 &normal = truth("normal");
    bool lit = false, dark = false, crease = false;
    for (int j = -3; j <= 3; ++j) {
      for (int i = -3; i <= 3; ++i) {
        const auto u = static_cast<uint32_t>(static_cast<int>(x) + i);
        const auto v = static_cast<uint32_t>(static_cast<int>(y) + j);
        if (u >= kExtent.width || v >= kExtent.height) continue;
        const bool is_lit = source.at(u, v, 1) > emission.at(u, v, 1);
        lit |= is_lit;
        dark |= !is_lit;
        float cosine = 0.0f;
        for (uint32_t c = 0; c < 3; ++c) cosine += normal.at(u, v, c) * normal.at(x, y, c);
        crease |= cosine < 0.9f;
      }
    }
    return (lit && dark) || crease;
  }

  float near_m_ = 0;
  reference::Rendering truth_;
};

TEST_P(DirectLightTest, SeesTheSameSurfaces) {
  const Pixels normal = pixels("normal"), depth = pixels("depth"), albedo = pixels("albedo");
  size_t misses = 0, others = 0, other_albedos = 0, compared = 0;
  for (size_t i = 0; i < depth.samples.size(); ++i) {
    const float z_m = truth("depth").samples[i];
    if ((z_m == 0.0f) != (depth.samples[i] == 0.0f)) ++misses;
    if (z_m == 0.0f || depth.samples[i] == 0.0f) continue;
    const vec3 n = octahedral_decode({normal.samples[2 * i], normal.samples[2 * i + 1]});
    const float* m = &truth("normal").samples[3 * i];
    // Depth is a 32-bit float; normal maps are filtered, and normals stored in 16 bits.
    const bool same = std::abs(near_m_ / depth.samples[i] / z_m - 1.0f) < 1e-4f &&
                      n.x * m[0] + n.y * m[1] + n.z * m[2] > 0.999f;
    if (!same) ++others;
    ++compared;
    if (!same) continue;
    // Base colour is stored in 8 bits of sRGB: half a step is 1 % of a dark colour. Levels of
    // textures are chosen for 2 x 2 pixels at once, which shows where they change fast.
    bool equal = true;
    for (size_t c = 0; c < 3; ++c) {
      const float want = truth("albedo").samples[3 * i + c];
      equal &= std::abs(albedo.samples[4 * i + c] - want) <= 0.02f * want + 0.002f;
    }
    if (!equal) ++other_albedos;
  }
  EXPECT_GT(compared, 10000u);
  EXPECT_LE(misses, 4u);
  EXPECT_LE(others, compared / 1000);  // rays at silhouettes go either way
  EXPECT_LE(other_albedos, compared / 100);
}

TEST_P(DirectLightTest, LightDiffersBesideEdgesAlone) {
  const Pixels source = pixels("source");
  const ImageF& want = truth("source");
  const float brightest = *std::max_element(want.samples.begin(), want.samples.end());
  size_t at_edges = 0, elsewhere = 0, lit = 0;
  for (uint32_t y = 0; y < kExtent.height; ++y) {
    for (uint32_t x = 0; x < kExtent.width; ++x) {
      bool differs = false;
      for (uint32_t c = 0; c < 3; ++c) {
        const float a = source.samples[(size_t{y} * kExtent.width + x) * source.channels + c];
        const float b = want.at(x, y, c);
        differs |= std::abs(a - b) > 0.05f * std::max(b, 2e-3f * brightest);
      }
      lit += want.at(x, y, 1) > 0.0f ? 1 : 0;
      if (differs) ++(beside_edge(x, y) ? at_edges : elsewhere);
    }
  }
  const double all = kExtent.width * kExtent.height;
  EXPECT_GT(lit, 3000u);
  EXPECT_LE(static_cast<double>(elsewhere) / all, 0.0005);
  EXPECT_LE(static_cast<double>(at_edges) / all, GetParam().most_at_edges);
  std::printf(
      "%s: %.3f %% of the pixels differ by more than 5 %% beside edges, %.3f %% elsewhere\n",
      GetParam().scene, 100 * static_cast<double>(at_edges) / all,
      100 * static_cast<double>(elsewhere) / all);
}

INSTANTIATE_TEST_SUITE_P(Scenes, DirectLightTest,
                         testing::Values(Case{"cornell", 0.01}, Case{"spot-floor", 0.001},
                                         Case{"atrium:triangles=20000", 0.04},
                                         Case{"panels", 0.01, panels, 1.5f}),
                         [](const auto& instance) {
                           const std::string name = instance.param.scene;
                           return name == "spot-floor" ? "spot_floor"
                                                       : name.substr(0, name.find(':'));
                         });

}  // namespace
}  // namespace lueur
