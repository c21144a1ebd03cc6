// SPDX-License-Identifier: MIT
// The drawings of FDP's figure 3 show what the technique does.
#include "paper_fdp_samples.h"

#include <algorithm>
#include <cmath>

#include "support/gpu_test.h"

namespace lueur::cli::fdp {
namespace {

TEST(Samples, LieInTheRing) {
  HierarchicalSettings settings;
  settings.radius = 40.0f;
  settings.sample_growth = 1;
  for (const uint32_t level : {0u, 1u, 3u}) {
    double least = 1e9, most = 0.0;
    const auto places = sample_pixels(settings, level, {7, 5}, 0);
    ASSERT_EQ(places.size(), 64u);
    for (const glm::ivec2 q : places) {
      const double distance = glm::length(glm::dvec2(q - glm::ivec2(7, 5)));
      least = std::min(least, distance);
      most = std::max(most, distance);
    }
    // Up to the pixel's diagonal, as a sample is the pixel that it falls into.
    EXPECT_LE(most, 40.0 + 0.75);
    EXPECT_GE(most, 39.0);
    if (level > 0)
      EXPECT_GE(least, 20.0 - 0.75);
    else
      EXPECT_LE(least, 5.0);
  }
}

class Participants : public GpuTest {
 protected:
  static constexpr Extent kExtent{160, 96};
  static constexpr glm::ivec2 kReceiver{80, 48};

  // The light at the receiver from those pixels alone for which `shines` says so.
  template <class Shines>
  double light_from(const HierarchicalSettings& settings, Shines shines) {
    // In a sphere each point sees each other one, all of them alike.
    CpuGBuffer g = cast_g_buffer(
        [](const glm::dvec3&, const glm::dvec3& d) {
          const glm::dvec3 n = glm::normalize(d);
          return std::optional(CpuHit{2.0 * n, -n, glm::dvec3(1.0)});
        },
        kExtent, 0.9, glm::dvec3(0.0));
    for (size_t i = 0; i < g.source.size(); ++i)
      if (!shines(i)) g.source[i] = glm::vec3(0.0f);
    Hierarchical technique(settings);
    run([&](Frame& frame) {
      const Inputs inputs{.view = g.view, .g_buffer = g.upload(frame.recorder()), .cut = true};
      frame.recorder().read_back("diffuse", technique.render(frame, inputs).diffuse);
    });
    const size_t at = size_t{kReceiver.y} * kExtent.width + kReceiver.x;
    return static_cast<double>(pixels("diffuse").samples[4 * at]);
  }
};

// All of its light comes from the pixels drawn, and each level's share of them gives some.
TEST_F(Participants, AreThoseThatLightComesFrom) {
  using Start = HierarchicalSettings::Start;
  for (const Start start : {Start::full, Start::half, Start::quarter}) {
    HierarchicalSettings settings;
    settings.start = start;
    settings.levels = 3;
    settings.samples = 12;
    settings.sample_growth = 1;
    settings.radius = 10;
    const auto taken = participating_pixels(settings, kExtent, kReceiver, 0);
    const double all = light_from(settings, [](size_t) { return true; });
    const double others = light_from(settings, [&](size_t i) { return taken[i] == 0; });
    ASSERT_GT(all, 0.0);
    // A sample on a pixel's border may fall to either side of it.
    EXPECT_LT(others, 0.005 * all) << int(start);
    EXPECT_GT(std::count(taken.begin(), taken.end(), 0), std::ptrdiff_t{1000}) << int(start);
    for (uint8_t level = 1; level <= 3; ++level)
      EXPECT_GT(light_from(settings, [&](size_t i) { return taken[i] == level; }), 0.01 * all)
          << int(start) << ' ' << int(level);
  }
}

}  // namespace
}  // namespace lueur::cli::fdp
