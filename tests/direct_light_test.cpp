// SPDX-License-Identifier: MIT
// The reference's direct light against the rasterizer's, pixel by pixel. Both look through the same
// points at the same surfaces; a shadow map has a soft edge where rays have a sharp one, and its
// texels cut corners. So they may differ beside edges of shadows and surfaces, and nowhere else.
#include <algorithm>
#include <cmath>

#include "reference/reference.h"
#include "renderer/renderer.h"
#include "scene/builtin/builtin.h"
#include "shading/packing.h"
#include "support/gpu_test.h"

namespace lueur {
namespace {

constexpr Extent kExtent{320, 180};

struct Case {
  const char* scene;
  // Share of the pixels that lie beside an edge and differ by more than 5 %: what the shadow maps
  // cost this scene. Twice what was seen, as drivers round their way around edges.
  double most_at_edges;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.scene;
}

class DirectLightTest : public GpuTest, public testing::WithParamInterface<Case> {
 protected:
  void SetUp() override {
    GpuTest::SetUp();
    const auto scene = make_builtin_scene(GetParam().scene);
    ASSERT_TRUE(scene.ok());
    near_m_ = scene->cameras[0].near_m;
    auto renderer = Renderer::create(system(), context(), *scene);
    ASSERT_TRUE(renderer.ok());
    run([&](Frame& frame) {
      const RenderedImages images = (*renderer)->record(frame, {.extent = kExtent}, nullptr);
      for (const auto& [name, image] :
           {std::pair{"source", images.source}, std::pair{"specular", images.specular},
            std::pair{"albedo", images.albedo}, std::pair{"normal", images.normal},
            std::pair{"depth", images.depth}})
        frame.recorder().read_back(name, image);
    });
    auto truth =
        reference::render(*scene, {.width = kExtent.width, .height = kExtent.height}, {.spp = 1});
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
                                         Case{"atrium:triangles=20000", 0.04}),
                         [](const auto& instance) {
                           const std::string name = instance.param.scene;
                           return name == "spot-floor" ? "spot_floor"
                                                       : name.substr(0, name.find(':'));
                         });

}  // namespace
}  // namespace lueur
