// SPDX-License-Identifier: MIT
// The environment behind everything: the rasterizer's pixels against the reference's, which looks
// it up on its own, interpolation included.
#include <cmath>
#include <numbers>
#include <random>

#include "reference/reference.h"
#include "renderer/renderer.h"
#include "support/gpu_test.h"
#include "support/test_scene.h"

namespace lueur {
namespace {

constexpr Extent kExtent{96, 64};

Environment picture(uint32_t width, const std::function<float(float u, float v)>& radiance) {
  Environment environment{.width = width, .height = width / 2};
  for (uint32_t y = 0; y < environment.height; ++y)
    for (uint32_t x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c)
        environment.rgb.push_back(
            radiance((static_cast<float>(x) + 0.5f) / static_cast<float>(width),
                     (static_cast<float>(y) + 0.5f) / static_cast<float>(environment.height)));
  return environment;
}

class BackgroundTest : public GpuTest {
 protected:
  // `contrast`: how far neighbouring pixels of the environment differ at most. Samplers round the
  // weights of an interpolation to 8 bits or more, in each direction; and half floats have 11 bits,
  // of texels and of results.
  void expect_same(const Scene& scene, double contrast) {
    auto renderer = Renderer::create(system(), context(), scene);
    ASSERT_TRUE(renderer.ok());
    run([&](Frame& frame) {
      const RenderedImages images = (*renderer)->record(frame, {.extent = kExtent}, nullptr);
      frame.recorder().read_back("composed", images.composed);
      frame.recorder().read_back("source", images.source);
    });
    const auto truth =
        reference::render(scene, {.width = kExtent.width, .height = kExtent.height}, {.spp = 1});
    ASSERT_TRUE(truth.ok());
    const ImageF &expected = *find_layer(*truth, ""), &depth = *find_layer(*truth, "depth");
    const Pixels composed = pixels("composed"), source = pixels("source");
    int seen = 0;
    for (size_t i = 0; i < depth.samples.size(); ++i) {
      if (depth.samples[i] > 0.0f) continue;
      ++seen;
      ASSERT_EQ(source.samples[4 * i], 0.0f) << "direct light holds the environment";
      const float found = composed.samples[4 * i];
      const auto exact = static_cast<double>(expected.samples[3 * i]);
      ASSERT_NEAR(static_cast<double>(found), exact, 2.0 / 256 * contrast + exact / 1024)
          << i % kExtent.width << " " << i / kExtent.width;
    }
    EXPECT_GT(seen, 1000);
  }
};

TEST_F(BackgroundTest, SeamAndPoleDoNotShow) {
  // A wave that goes around once, so that it is smooth across the seam, which lies along +z.
  const Environment wave = picture(
      64, [](float u, float) { return 2.0f + std::sin(2.0f * std::numbers::pi_v<float> * u); });
  for (const glm::vec3& target : {glm::vec3(0.1f, 0.2f, 1), glm::vec3(0.01f, 1, 0.02f)}) {
    Scene scene = scene_seen_from({0, 0, 0}, target);
    add_quad(scene, 3.0f * target - 0.2f, {0.4f, 0, 0}, {0, 0.4f, 0.1f});
    scene.materials[0].double_sided = true;
    scene.environment = wave;
    scene.environment->rotation_rad = 0.3f;
    scene.environment->intensity = 4.0f;
    expect_same(scene, 4.0 * 2.0 * std::numbers::pi / 64);
  }
}

TEST_F(BackgroundTest, FinePicturesAreShownAtAMeanLevel) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> anything(0.0f, 1.0f);
  Scene scene = scene_seen_from({0, 0, 0}, {0.3f, 0.1f, -1});
  scene.environment = picture(1024, [&](float, float) { return anything(random); });
  const float pixel_rad = scene.cameras[0].vertical_fov_rad / static_cast<float>(kExtent.height);
  ASSERT_GT(background_level(*scene.environment, pixel_rad), 0u);
  expect_same(scene, 1.0);
}

}  // namespace
}  // namespace lueur
