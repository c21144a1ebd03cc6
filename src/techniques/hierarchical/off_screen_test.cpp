// SPDX-License-Identifier: MIT
// Light of what the camera does not see, against the sum over a map around the eye in double
// precision.
#include "lights/square_views.h"
#include "techniques/hierarchical/hierarchical_fixture.h"

namespace lueur {
namespace {

using OffScreenTest = HierarchicalTest;

class SphereHost final : public Host {
 public:
  GBuffer render_view(Frame& frame, const View& view, Extent extent, const ViewContent&) override {
    ++views;
    return seen_through(striped_sphere, view, extent).upload(frame.recorder());
  }
  std::span<const PunctualLight> lights() const override { return {}; }
  Box bounds() const override { return {{-2, -2, -2}, {2, 2, 2}}; }
  std::span<const TriangleBatch> triangles(Frame&) override { return {}; }
  int views = 0;
};

// What the faces around the eye show beside the picture, as LCM has it: means over 16 x 16 pixels.
glm::dvec3 beside_the_picture(const CpuGBuffer& g, const glm::dvec3& eye, const glm::dvec3& x,
                              const glm::dvec3& n) {
  constexpr uint32_t kSide = 8, kFactor = 16, kPx = kSide * kFactor;
  static std::vector<CpuGBuffer> faces;
  if (faces.empty())
    for (const View& view : cube_views(eye))
      faces.push_back(seen_through(striped_sphere, view, {kPx, kPx}));
  const glm::dmat4 camera = glm::inverse(world_from_view(g.view));
  glm::dvec3 sum(0);
  for (const CpuGBuffer& face : faces) {
    for (uint32_t t = 0; t < kSide * kSide; ++t) {
      glm::dvec3 radiance(0);
      double distance = 0;
      for (uint32_t i = 0; i < kFactor * kFactor; ++i) {
        const size_t pixel =
            (t / kSide * kFactor + i / kFactor) * kPx + t % kSide * kFactor + i % kFactor;
        radiance += glm::dvec3(face.source[pixel]) / double(kFactor * kFactor);
        distance += glm::length(face.position_view[pixel]) / (kFactor * kFactor);
      }
      const glm::dvec3 ray((t % kSide * 2 + 1.0) / kSide - 1, 1 - (t / kSide * 2 + 1.0) / kSide,
                           -1);
      const double l = glm::length(ray);
      const glm::dvec3 y(world_from_view(face.view) * glm::dvec4(ray / l * distance, 1));
      const glm::dvec3 seen(camera * glm::dvec4(y, 1));
      const double px = seen.x / -seen.z * g.view.clip_from_view[0];
      const double py = seen.y / -seen.z * g.view.clip_from_view[5];
      if (seen.z < 0 && std::abs(px) < 1 && std::abs(py) < 1) continue;
      const double w = 4 / (kSide * kSide * l * l * l + 4 / kPi) / kPi;
      const glm::dvec3 way = y - x;
      const double r2 = glm::dot(way, way);
      sum += radiance * std::max(glm::dot(n, way) / std::sqrt(r2), 0.0) * distance * distance * w /
             (r2 * (1 - w) + distance * distance * w);
    }
  }
  return sum;
}

TEST_F(OffScreenTest, AMapAddsWhatLiesBesideThePicture) {
  const glm::dvec3 eye(0);  // where the sphere is seen from
  const CpuGBuffer g = cast_g_buffer(striped_sphere, {32, 20}, 0.9, eye);
  Settings settings = exhaustive();
  const Light without = diffuse(g, settings);
  settings.off_screen = Settings::OffScreen::map;
  SphereHost host;
  Hierarchical technique(settings);
  const Light with = next_frame(technique, g, {.host = &host}).diffuse;
  EXPECT_EQ(host.views, 6);
  for (size_t i = 0; i < with.size(); ++i) {
    const glm::dvec3 x(world_from_view(g.view) * glm::dvec4(g.position_view[i], 1));
    const glm::dvec3 want = without[i] + beside_the_picture(g, eye, x, glm::dvec3(g.normal[i]));
    for (int c = 0; c < 3; ++c) ASSERT_NEAR(with[i][c], want[c], 3e-3 * want[c]) << i;
  }
}

}  // namespace
}  // namespace lueur
