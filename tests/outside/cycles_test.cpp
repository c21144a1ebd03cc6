// SPDX-License-Identifier: MIT
// The reference against a renderer by others: Cycles, of Blender 3.4. See docs/reference_check.md.
//
// Both shoot their rays through the pixels' centres at the same triangles, so pictures are compared
// pixel by pixel, silhouettes included.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "image/exr.h"
#include "outside/agreement.h"
#include "outside/outside_scenes.h"
#include "scene/gltf_export.h"
#include "support/cli.h"

namespace lueur {
namespace {

constexpr uint32_t kSide = 64;  // pixels

using Layers = std::vector<ImageLayer>;

const ImageF& layer(const Layers& layers, const std::string& name) {
  static const ImageF kMissing(kSide, kSide, 3);
  for (const ImageLayer& candidate : layers)
    if (candidate.name == name) return candidate.image;
  ADD_FAILURE() << "no layer " << name;
  return kMissing;
}

ImageF product(ImageF a, const ImageF& b) {
  for (size_t i = 0; i < a.samples.size(); ++i) a.samples[i] *= b.samples[i];
  return a;
}

ImageF sum(ImageF a, const ImageF& b) {
  for (size_t i = 0; i < a.samples.size(); ++i) a.samples[i] += b.samples[i];
  return a;
}

// Layers of Cycles: what lobe `lobe` sends to the eye of light that comes `way`.
ImageF radiance(const Layers& cycles, const std::string& lobe, const std::string& way) {
  return product(layer(cycles, "ViewLayer." + lobe + way),
                 layer(cycles, "ViewLayer." + lobe + "Col"));
}

// More samples for closer figures: LUEUR_OUTSIDE_SCALE multiplies them.
uint32_t scaled(uint32_t spp) {
  const char* text = std::getenv("LUEUR_OUTSIDE_SCALE");
  const int scale = text ? std::atoi(text) : 1;
  return spp * static_cast<uint32_t>(std::clamp(scale, 1, 256));
}

class CyclesTest : public Cli {
 protected:
  void SetUp() override {
    Cli::SetUp();
    // What Blender leaves behind goes with the folder.
    ::setenv("HOME", folder_.c_str(), 1);
    ::setenv("TMPDIR", folder_.c_str(), 1);
    const Ended probe = blender({"--python-exit-code", "9", "--python-expr",
                                 "import sys, bpy, numpy\n"
                                 "sys.exit(0 if bpy.app.version[:2] == (3, 4) else 8)"});
    switch (probe.code) {
      case 0:
        break;
      case 127:
        GTEST_SKIP() << "no Blender here: install the package blender for this check";
      case 9:
        GTEST_SKIP() << "Blender lacks numpy: install the package python3-numpy";
      case 8:
        GTEST_SKIP() << "this check knows Blender 3.4, and the one here is another";
      default:
        FAIL() << "blender ended with " << probe.code << "\n" << probe.err;
    }
  }

  Ended blender(const Arguments& more) const {
    Arguments arguments = {"-b", "--factory-startup", "-noaudio"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_other("blender", arguments, "stdout", scaled(120));
  }

  void use(const Scene& scene) const { ASSERT_TRUE(export_glb(scene, folder_ / "scene.glb").ok()); }

  Layers cycles(uint32_t bounces, uint32_t spp, uint32_t seed) const {
    const Ended ended =
        blender({"--python-exit-code", "1", "-P", LUEUR_CYCLES_SCRIPT, "--", "scene.glb",
                 "cycles.exr", "--size", size(), "--bounces", std::to_string(bounces), "--spp",
                 std::to_string(spp), "--seed", std::to_string(seed)});
    EXPECT_EQ(ended.code, 0) << ended.err << ended.out;
    return read("cycles.exr");
  }

  Layers reference(uint32_t bounces, uint32_t spp, uint32_t seed) const {
    const Ended ended = run({"reference", "scene.glb", "-o", "ours.exr", "--size", size(),
                             "--bounces", std::to_string(bounces), "--spp", std::to_string(spp),
                             "--seed", std::to_string(seed), "--no-cache"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    return read("ours.exr");
  }

  // Renders with both, two seeds each.
  void render(uint32_t our_bounces, uint32_t bounces_of_cycles, uint32_t spp_of_cycles = 256) {
    for (uint32_t seed : {0u, 1u}) {
      ours_.push_back(reference(our_bounces, scaled(512), seed));
      cycles_.push_back(cycles(bounces_of_cycles, scaled(spp_of_cycles), seed));
    }
  }

  // Compares what `ours` and `theirs` take from the layers of each renderer.
  template <class Ours, class Theirs>
  Agreement compare(Ours&& ours, Theirs&& theirs) const {
    return agreement({ours(ours_[0]), ours(ours_[1])}, {theirs(cycles_[0]), theirs(cycles_[1])});
  }

  // Light without noise. Cycles spreads its rays over a hundredth of a pixel and loses some that
  // start on the edge between two triangles, so single pixels along edges may be others.
  static void expect_equal(const ImageF& ours, const ImageF& theirs) {
    double mean_ours = 0, mean_theirs = 0;
    for (const float value : ours.samples) mean_ours += value;
    for (const float value : theirs.samples) mean_theirs += value;
    const double least = 0.1 * mean_theirs / static_cast<double>(theirs.samples.size());
    uint32_t others = 0;
    for (uint32_t i = 0; i < kSide * kSide; ++i) {
      bool is_other = false;
      for (uint32_t c = 0; c < 3; ++c) {
        const double a = ours.samples[3 * i + c], b = theirs.samples[3 * i + c];
        is_other |= std::abs(a - b) > 0.01 * (b + least);
      }
      others += is_other ? 1 : 0;
    }
    EXPECT_GT(mean_theirs, 0.0);
    EXPECT_NEAR(mean_ours / mean_theirs, 1.0, 1e-3);
    EXPECT_LE(others, kSide * kSide / 100);
    std::printf("direct: bias %+.4f %%, %u of %u pixels differ by more than 1 %%\n",
                100 * (mean_ours / mean_theirs - 1), others, kSide * kSide);
  }

  // Five standard errors are passed by chance once in two million times; a thousandth is left for
  // the rays that Cycles loses. All errors are estimates themselves: that of a square of 64 pixels
  // to a tenth, more where few paths carry most of its light.
  static void expect_agreement(const Agreement& a) {
    std::printf("indirect: %s\n", to_string(a).c_str());
    EXPECT_LE(std::abs(a.bias), 5.0 * a.standard_error + 1e-3);
    EXPECT_LE(a.standard_error, 0.005) << "too noisy to tell";
    EXPECT_LE(a.rmse, 1.1 * a.noise);
    EXPECT_LE(a.square_z, 1.5);
    EXPECT_LE(a.greatest_square_z, 6.0);
  }

  std::vector<Layers> ours_, cycles_;  // a seed each

 private:
  static std::string size() { return std::to_string(kSide) + "x" + std::to_string(kSide); }
  Layers read(const char* name) const {
    auto layers = read_exr(folder_ / name);
    EXPECT_TRUE(layers.ok()) << (layers.ok() ? "" : layers.error().message);
    return layers.ok() ? std::move(*layers) : Layers();
  }
};

ImageF our_direct(const Layers& ours) {
  ImageF direct = layer(ours, "source");
  const ImageF& emission = layer(ours, "emission");
  for (size_t i = 0; i < direct.samples.size(); ++i) direct.samples[i] -= emission.samples[i];
  return direct;
}

// One light above a floor: both against the closed form, so that light means the same in both.
TEST_F(CyclesTest, LightsOverAFloor) {
  const glm::vec3 place(0.4f, 2.0f, -0.3f);
  const glm::vec3 direction = glm::normalize(glm::vec3(0.2f, -1.0f, 0.1f));
  const float inner = 0.2f, outer = 0.6f;
  const Light lights[] = {{.name = "point", .kind = LightKind::point, .intensity = 30.0f},
                          {.name = "sun", .kind = LightKind::directional, .intensity = 7.0f},
                          {.name = "spot",
                           .kind = LightKind::spot,
                           .intensity = 30.0f,
                           .inner_cone_rad = inner,
                           .outer_cone_rad = outer}};
  for (const Light& light : lights) {
    SCOPED_TRACE(light.name);
    use(floor_below(light, place, direction));
    ImageF truth(kSide, kSide, 3);
    for (uint32_t y = 0; y < kSide; ++y) {
      for (uint32_t x = 0; x < kSide; ++x) {
        const auto metres = [](uint32_t pixel) {
          return ((static_cast<float>(pixel) + 0.5f) / kSide - 0.5f) * kFloorHeight;
        };
        const glm::vec3 way = place - glm::vec3(metres(x), 0.0f, metres(y));
        const float distance = glm::length(way);
        float lux = light.intensity * way.y / (distance * distance * distance);
        if (light.kind == LightKind::directional) lux = light.intensity * -direction.y;
        if (light.kind == LightKind::spot) {
          const float cosine = glm::dot(-way, direction) / distance;
          const float ramp = (cosine - std::cos(outer)) / (std::cos(inner) - std::cos(outer));
          lux *= std::pow(std::clamp(ramp, 0.0f, 1.0f), 2.0f);
        }
        for (uint32_t c = 0; c < 3; ++c) truth.at(x, y, c) = kFloorAlbedo * lux / 3.14159265f;
      }
    }
    expect_equal(our_direct(reference(1, 1, 0)), truth);
    expect_equal(radiance(cycles(0, 1, 0), "Diff", "Dir"), truth);
  }
}

TEST_F(CyclesTest, CornellBoxLitByItsSpot) {
  use(cornell_lit_by_spot());
  for (const uint32_t bounces : {1u, 4u}) {
    ours_.clear();
    cycles_.clear();
    render(bounces, bounces);
    expect_equal(our_direct(ours_[0]), radiance(cycles_[0], "Diff", "Dir"));
    expect_agreement(compare([](const Layers& l) { return layer(l, "indirect"); },
                             [](const Layers& l) { return layer(l, "ViewLayer.DiffInd"); }));
  }
}

// What glows is a surface to us: its light is indirect, and one bounce of it arrives straight from
// the panel. Cycles calls that light direct, and counts from the next surface.
TEST_F(CyclesTest, CornellBoxLitByItsPanel) {
  use(cornell_lit_by_glow());
  render(2, 1, 1024);  // noisy: it meets the panel by chance
  expect_agreement(compare([](const Layers& l) { return layer(l, "indirect"); },
                           [](const Layers& l) {
                             return sum(layer(l, "ViewLayer.DiffDir"),
                                        layer(l, "ViewLayer.DiffInd"));
                           }));
}

TEST_F(CyclesTest, StillLifeWithMetal) {
  use(still_life());
  render(3, 3);
  expect_equal(layer(ours_[0], "direct"),
               sum(radiance(cycles_[0], "Diff", "Dir"), radiance(cycles_[0], "Gloss", "Dir")));
  expect_agreement(compare(
      [](const Layers& l) {
        return sum(product(layer(l, "indirect"), layer(l, "albedo")),
                   layer(l, "indirect_specular"));
      },
      [](const Layers& l) {
        return sum(radiance(l, "Diff", "Ind"), radiance(l, "Gloss", "Ind"));
      }));
}

}  // namespace
}  // namespace lueur
