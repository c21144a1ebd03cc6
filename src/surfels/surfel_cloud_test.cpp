// SPDX-License-Identifier: MIT
// Clouds of triangles of all kinds: their area, and the size of what they are made of.
#include "surfels/surfel_cloud.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/gpu_test.h"
#include "surfels/test_shaders/shaders.h"

namespace lueur {
namespace {

struct Disc {
  glm::dvec3 position, normal;
  double radius_m;
};

class SurfelCloudTest : public GpuTest {
 protected:
  // Looks along -z from the origin, 90 degrees wide.
  SurfelCloudTest() {
    const float side = 2.0f / float(kExtent.width);
    info_.screen.ray_scale = {side, -side};
    info_.screen.ray_offset = {-1.0f, 1.0f};
    info_.extent = kExtent;
    info_.margin_m = 100.0f;
  }
  void add_triangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    for (const glm::vec3& corner : {a, b, c}) {
      indices_.push_back(static_cast<uint32_t>(positions_.size()));
      positions_.push_back(corner);
    }
  }
  // Steps x steps squares of two triangles each.
  void add_quad(const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v, int steps = 1) {
    for (int y = 0; y < steps; ++y) {
      for (int x = 0; x < steps; ++x) {
        const float n = float(steps);
        const glm::vec3 a = corner + u * (float(x) / n) + v * (float(y) / n);
        add_triangle(a, a + u / n, a + u / n + v / n);
        add_triangle(a, a + u / n + v / n, a + v / n);
      }
    }
  }
  std::vector<Disc> cloud() {
    run([&](Frame& frame) {
      Recorder& recorder = frame.recorder();
      if (indices_.empty()) add_triangle({}, {}, {});  // which has no area
      TriangleRange range{.index_count = static_cast<uint32_t>(indices_.size())};
      for (size_t i = 0; i < 16; i += 5) range.world_from_object[i] = 1.0f;
      const TriangleBatch batch{.vertices = recorder.upload(positions_),
                                .indices = recorder.upload(indices_),
                                .ranges = {range}};
      info_.triangles = {&batch, 1};
      const SurfelCloud made = surfelize(recorder, info_);
      const Image image =
          recorder.image("image", {2 * kColumns, 1 + divide_up(info_.surfels_capacity, kColumns)},
                         Format::rgba32f);
      recorder.dispatch("test.to_image", {.shader = shaders::surfels_test_shaders_to_image_comp,
                                          .read = {{"list", made.list}},
                                          .write = {{"geometry", image}},
                                          .over = {kColumns, image.extent.height}});
      recorder.read_back("image", image);
    });
    const Pixels found = pixels("image");
    count_ = found.samples[0];
    std::vector<Disc> discs;
    for (size_t i = 8 * kColumns; i + 7 < found.samples.size(); i += 8) {
      const float* s = &found.samples[i];
      if (s[7] == 1.0f) discs.push_back({{s[0], s[1], s[2]}, {s[4], s[5], s[6]}, s[3]});
    }
    return discs;
  }
  static double area_of(const std::vector<Disc>& discs) {
    double area = 0;
    for (const Disc& disc : discs) area += kPi * disc.radius_m * disc.radius_m;
    return area;
  }

  static constexpr Extent kExtent{512, 512};
  static constexpr uint32_t kColumns = 512;
  SurfelizeInfo info_;
  std::vector<glm::vec3> positions_;
  std::vector<uint32_t> indices_;
  float count_ = 0;
};

TEST_F(SurfelCloudTest, AHugeTriangleKeepsItsArea) {
  // A floor that goes on below the eye.
  add_quad({-20, -1.5f, 5}, {40, 0, 0}, {0, 0, -40});
  info_.surfels_capacity = 1u << 18;
  const auto discs = cloud();
  EXPECT_GT(discs.size(), 15'000u);
  EXPECT_NEAR(area_of(discs) / 1600, 1, 0.01);
  for (const Disc& disc : discs) ASSERT_GT(disc.normal.y, 0.999);
}

// Next to the eye there are fewer fine surfels than wanted: each then stands for more.
TEST_F(SurfelCloudTest, WhatIsVeryNearKeepsItsArea) {
  add_quad({-100, -0.5f, 100}, {200, 0, 0}, {0, 0, -200});
  info_.margin_m = 300.0f;
  info_.radius_px = 2.0f;
  info_.surfels_capacity = 1u << 18;
  const auto discs = cloud();
  double near_area = 0;
  for (const Disc& disc : discs)
    if (glm::length(disc.position) < 2)
      near_area += kPi * disc.radius_m * disc.radius_m / (kPi * (4 - 0.25));
  EXPECT_NEAR(near_area, 1, 0.03);
  EXPECT_NEAR(area_of(discs) / 40'000, 1, 0.01);
}

TEST_F(SurfelCloudTest, ThinTrianglesKeepTheirArea) {
  for (int i = 0; i < 2000; ++i) {
    const float x = -2 + 0.002f * float(i);
    add_triangle({x, -2, -3}, {x + 0.0015f, -2, -3}, {x, 2, -3});
  }
  info_.radius_px = 1.5f;
  const auto discs = cloud();
  EXPECT_NEAR(area_of(discs) / (2000 * 0.5 * 0.0015 * 4), 1, 0.01) << discs.size();
  // Along the whole of it: the mean height of a triangle is a third.
  const double area = area_of(discs);
  double height = 0;
  for (const Disc& disc : discs)
    height += disc.position.y * kPi * disc.radius_m * disc.radius_m / area;
  EXPECT_NEAR(height, -2 + 4.0 / 3, 0.03);
}

TEST_F(SurfelCloudTest, TinyTrianglesKeepTheirArea) {
  // 131 072 of them, of which about one in four becomes a surfel.
  add_quad({-2, -2, -3}, {4, 0, 0}, {0, 4, 0}, 256);
  info_.radius_px = 1.0f;
  const auto discs = cloud();
  EXPECT_GT(discs.size(), 20'000u);
  EXPECT_LT(discs.size(), 60'000u);
  EXPECT_NEAR(area_of(discs) / 16, 1, 0.01);
}

TEST_F(SurfelCloudTest, SurfelsLookEquallyLarge) {
  add_quad({-20, -1.5f, 5}, {40, 0, 0}, {0, 0, -40});
  add_quad({-2, -1, -3}, {4, 0, 0}, {0, 4, 0}, 64);
  info_.surfels_capacity = 1u << 18;
  const double pixel = 2.0 / kExtent.width;
  for (const Disc& disc : cloud())
    ASSERT_NEAR(disc.radius_m / (glm::length(disc.position) * pixel), info_.radius_px, 1e-3);
}

TEST_F(SurfelCloudTest, WhatIsFarBesideTheViewIsLeftOut) {
  info_.margin_m = 1.0f;
  add_quad({-40, -2, -10}, {80, 0, 0}, {0, 4, 0}, 40);  // the view is 20 m wide there
  double most = 0;
  for (const Disc& disc : cloud()) most = std::max(most, std::abs(disc.position.x));
  EXPECT_GT(most, 10 + 1.2);  // a metre across the side of the view, which is turned by 45 degrees
  EXPECT_LT(most, 10 + 1.5 + 2 * std::sqrt(2.0) + 1);
}

// Two frames give the same cloud, in some order.
TEST_F(SurfelCloudTest, CloudsStayWhatTheyAre) {
  add_quad({-2, -1.5f, -1}, {4, 0, 0}, {0, 0, -4}, 4);
  const auto sum = [](const std::vector<Disc>& discs) {
    glm::dvec4 all(0);
    for (const Disc& disc : discs) all += glm::dvec4(disc.position * disc.position, disc.radius_m);
    return all;
  };
  const auto first = cloud();
  const glm::dvec4 a = sum(first), b = sum(cloud());
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(a[i], b[i], 1e-9 * a[i]);
}

TEST_F(SurfelCloudTest, WhatFindsNoRoomIsCounted) {
  add_quad({-2, -2, -3}, {4, 0, 0}, {0, 4, 0}, 32);
  const size_t all = cloud().size();
  info_.surfels_capacity = 100;
  EXPECT_EQ(cloud().size(), 100u);
  EXPECT_EQ(count_, float(all));
}

TEST_F(SurfelCloudTest, APointMakesNothing) {
  EXPECT_TRUE(cloud().empty());
}

}  // namespace
}  // namespace lueur
