// SPDX-License-Identifier: MIT
#include "cube_maps/cube_capture.h"

#include <gtest/gtest.h>

#include "lights/square_views.h"
#include "support/gpu_test.h"

namespace lueur {
namespace {

constexpr double kFar = 50;

// A wall of radiance (1, 2, 4) (1 + x) 3 m to the right; nothing else.
std::optional<CpuHit> wall(const glm::dvec3& o, const glm::dvec3& d) {
  if (d.x <= 0) return std::nullopt;
  const glm::dvec3 p = o + (3 - o.x) / d.x * d;
  if (glm::any(glm::greaterThan(glm::abs(p), glm::dvec3(4)))) return std::nullopt;
  return CpuHit{p, {-1, 0, 0}, glm::dvec3(1, 2, 4) * (5 + p.y)};
}

class WallHost final : public Host {
 public:
  explicit WallHost(bool has_sky) : has_sky_(has_sky) {}
  GBuffer render_view(Frame& frame, const View& view, Extent extent,
                      const ViewContent& content) override {
    without.assign(content.without.begin(), content.without.end());
    return seen_through(wall, view, extent).upload(frame.recorder());
  }
  Image background(Frame& frame, const View&, Extent extent) override {
    if (!has_sky_) return {};
    const std::vector<glm::vec4> sky(size_t{extent.width} * extent.height, {7, 6, 5, 0});
    return frame.recorder().upload_image("sky", extent, Format::rgba32f, sky.data());
  }
  std::span<const PunctualLight> lights() const override { return {}; }
  Box bounds() const override { return {}; }
  std::span<const TriangleBatch> triangles(Frame&) override { return {}; }

  std::vector<uint32_t> without;

 private:
  bool has_sky_;
};

class CubeCaptureTest : public GpuTest {
 protected:
  // The texels' means in double precision, and the device's beside it.
  void expect_means(uint32_t picture_px, uint32_t side, bool has_sky) {
    const View view = cube_views({0.5f, 0.25f, 0})[face_];
    WallHost host(has_sky);
    const uint32_t objects[] = {3, 7};
    run([&](Frame& frame) {
      const Image texels = frame.recorder().image("texels", {side, side}, kCubeTexelFormat);
      capture_face(frame, host, view,
                   {.picture_px = picture_px, .side = side, .without = objects, .far_m = kFar},
                   texels, {0, 0});
      frame.recorder().read_back("texels", texels);
    });
    EXPECT_EQ(host.without, std::vector<uint32_t>({3, 7}));
    const Pixels found = pixels("texels");
    const CpuGBuffer g = seen_through(wall, view, {picture_px, picture_px});
    const uint32_t factor = picture_px / side;
    for (uint32_t y = 0; y < side; ++y) {
      for (uint32_t x = 0; x < side; ++x) {
        glm::dvec4 mean(0);
        int count = 0;
        for (uint32_t i = 0; i < factor * factor; ++i) {
          const size_t pixel =
              size_t{y * factor + i / factor} * picture_px + x * factor + i % factor;
          const bool is_wall = g.depth[pixel] > 0;
          (is_wall ? saw_wall_ : saw_sky_) = true;
          const glm::dvec3 light = is_wall   ? glm::dvec3(g.source[pixel])
                                   : has_sky ? glm::dvec3(7, 6, 5)
                                             : glm::dvec3(0);
          mean += glm::dvec4(light / double(factor * factor), 0);
          if (!is_wall && !has_sky) continue;
          mean.w += is_wall ? glm::length(g.position_view[pixel]) : kFar;
          ++count;
        }
        mean.w = count > 0 ? mean.w / count : kFar;
        for (int c = 0; c < 4; ++c)
          EXPECT_NEAR(found.samples[4 * (y * side + x) + size_t(c)], mean[c], 1e-3 * mean[c])
              << x << ' ' << y << ' ' << c;
      }
    }
  }
  size_t face_ = 0;
  bool saw_wall_ = false, saw_sky_ = false;
};

TEST_F(CubeCaptureTest, TexelsAreMeansOfRadianceAndDistance) {
  for (face_ = 0; face_ < 6; ++face_) {
    expect_means(64, 8, true);
    expect_means(64, 2, false);
    expect_means(64, 64, false);
  }
  EXPECT_TRUE(saw_wall_ && saw_sky_);
}

}  // namespace
}  // namespace lueur
