// SPDX-License-Identifier: MIT
// The papers' formulas on the CPU, against closed forms.
#include "techniques/hierarchical/equations.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "shading/form_factor.h"
#include "shading/packing.h"

namespace lueur {
namespace {

constexpr double kPi = std::numbers::pi;

// E/pi under a parallel disc of radius a and radiance 1 at height h.
double disc_closed_form(double a, double h) {
  return a * a / (h * h + a * a);
}

// The disc cut into rings x sectors, each one sample.
double subdivided_disc(double a, double h, int rings, bool point) {
  double sum = 0;
  for (int ring = 0; ring < rings; ++ring) {
    const double inner = a * ring / rings, outer = a * (ring + 1) / rings;
    const int sectors = 6 * (2 * ring + 1);
    const double area = kPi * (outer * outer - inner * inner) / sectors;
    const double radius = std::sqrt(0.5 * (inner * inner + outer * outer));
    for (int s = 0; s < sectors; ++s) {
      const double angle = 2 * kPi * (s + 0.5) / sectors;
      const vec3 to_patch(radius * std::cos(angle), radius * std::sin(angle), h);
      const auto form = point ? point_form_factor : disc_form_factor;
      sum += form(to_patch, vec3(0, 0, 1), vec3(0, 0, -1), static_cast<float>(area / kPi));
    }
  }
  return sum;
}

TEST(FormFactor, OneSampleIsExactForAParallelDisc) {
  for (const double h : {0.001, 0.1, 1.0, 10.0}) {
    const double a = 0.7;
    const float one = disc_form_factor(vec3(0, 0, h), vec3(0, 0, 1), vec3(0, 0, -1),
                                       static_cast<float>(a * a));  // pi a^2 / pi
    EXPECT_NEAR(one, disc_closed_form(a, h), 1e-5) << "h = " << h;
  }
}

TEST(FormFactor, SubdivisionConvergesAtEveryHeight) {
  for (const double h : {0.05, 0.5, 5.0}) {
    const double exact = disc_closed_form(1.0, h);
    const auto error = [&](int rings) {
      return std::abs(subdivided_disc(1.0, h, rings, false) - exact) / exact;
    };
    // Where the pieces are small against h the error falls with their area.
    EXPECT_LT(error(64), 0.25 * error(16) + 1e-5) << "h = " << h;
    EXPECT_LT(error(256), 0.01) << "h = " << h;
  }
}

TEST(FormFactor, PointFormDivergesWhereTheDiscStaysBounded) {
  const auto at = [](double h, bool point) {
    const auto form = point ? point_form_factor : disc_form_factor;
    return form(vec3(0, 0, h), vec3(0, 0, 1), vec3(0, 0, -1), 0.01f);
  };
  EXPECT_GT(at(1e-3, true), 100.0f);
  EXPECT_GT(at(1e-4, true), 50.0f * at(1e-3, true));
  EXPECT_LE(at(1e-4, false), 1.0f);
  // Far away the two agree.
  EXPECT_NEAR(at(10, true) / at(10, false), 1.0f, 1e-3f);
}

TEST(FormFactor, SurfacesThatFaceAwayGiveNothing) {
  EXPECT_EQ(disc_form_factor(vec3(0, 0, 1), vec3(0, 0, -1), vec3(0, 0, -1), 1.0f), 0.0f);
  EXPECT_EQ(disc_form_factor(vec3(0, 0, 1), vec3(0, 0, 1), vec3(0, 0, 1), 1.0f), 0.0f);
  EXPECT_EQ(disc_form_factor(vec3(0), vec3(0, 0, 1), vec3(0, 0, 1), 1.0f), 0.0f);
}

TEST(FormFactor, ForeshorteningIsOneOnAScreenParallelPlane) {
  for (const vec2 ray : {vec2(0), vec2(0.5f, -0.3f), vec2(2, 2)})
    EXPECT_FLOAT_EQ(foreshortening(vec3(0, 0, 1), ray, 20.0f), 1.0f);
  // A plane tilted by 60 degrees, seen along the axis: 1 / cos 60.
  const vec3 tilted(std::sin(kPi / 3), 0, std::cos(kPi / 3));
  EXPECT_NEAR(foreshortening(tilted, vec2(0), 20.0f), 2.0f, 1e-5f);
  EXPECT_FLOAT_EQ(foreshortening(vec3(1, 0, 0), vec2(0), 20.0f), 20.0f);
}

// HSSIL (2) summed over the image is the area that the camera sees.
TEST(FormFactor, PixelAreasAddUpToThePlane) {
  const vec3 normal = normalize(vec3(0.3f, 0.5f, 1.0f));
  constexpr int kSide = 400;
  const double tan_half = 0.4;
  double area = 0;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const vec2 ray((2.0 * (x + 0.5) / kSide - 1) * tan_half,
                     (2.0 * (y + 0.5) / kSide - 1) * tan_half);
      // The plane n.p = n.(0,0,-3): z along this ray.
      const double z = 3.0 * normal.z / (normal.z - normal.x * ray.x - normal.y * ray.y);
      area +=
          z * z * 4 * tan_half * tan_half / (kSide * kSide) * foreshortening(normal, ray, 20.0f);
    }
  }
  // The four corners of what is seen, as two triangles.
  const auto corner = [&](double sx, double sy) {
    const vec2 ray(sx * tan_half, sy * tan_half);
    const double z = 3.0 * normal.z / (normal.z - normal.x * ray.x - normal.y * ray.y);
    return glm::dvec3(ray.x * z, ray.y * z, -z);
  };
  const auto a = corner(-1, -1), b = corner(1, -1), c = corner(1, 1), d = corner(-1, 1);
  const double exact =
      0.5 * (glm::length(glm::cross(b - a, c - a)) + glm::length(glm::cross(c - a, d - a)));
  EXPECT_NEAR(area / exact, 1.0, 1e-4);
}

TEST(Rings, TileThePlane) {
  for (const float r : {1.0f, 20.0f, 40.0f}) {
    double covered = 0;
    for (uint level = 0; level < 8; ++level) {
      const double scale = std::pow(2.0, level);
      // Where this ring begins, the one before has ended.
      if (level > 0) {
        EXPECT_FLOAT_EQ(ring_inner_px(level, r) * static_cast<float>(scale),
                        r * static_cast<float>(scale / 2));
      }
      covered += ring_area_px(level, r) * scale * scale;
      EXPECT_NEAR(covered / (kPi * r * r * scale * scale), 1.0, 1e-5) << "level " << level;
    }
  }
}

TEST(Rings, SamplesAreInTheirRingWithEqualAreas) {
  constexpr uint kSamples = 64;
  for (uint level = 0; level < 3; ++level) {
    const float inner = ring_inner_px(level, 20), outer = 20;
    const float step = sample_step_px2(inner, outer, kSamples);
    for (uint i = 0; i < kSamples; ++i) {
      const float lo = sample_radius_px(inner, step, static_cast<float>(i));
      const float hi = sample_radius_px(inner, step, static_cast<float>(i + 1));
      EXPECT_GE(lo, inner);
      EXPECT_LE(hi, outer * 1.0001f);
      EXPECT_NEAR(kPi * (hi * hi - lo * lo), ring_area_px(level, 20) / kSamples, 1e-2);
    }
  }
}

// Nine neighbours together must be spread evenly, or the 3 x 3 filter leaves a pattern.
TEST(Rings, NineNeighboursInterleave) {
  for (const uint seed : {0u, 1u, 77u}) {
    std::vector<float> shifts, turns;
    for (uint y = 0; y < 3; ++y) {
      for (uint x = 0; x < 3; ++x) {
        const vec2 start = spiral_start(uvec2(x + 6, y + 9), 2, seed, true);
        shifts.push_back(start.x);
        turns.push_back(start.y);
      }
    }
    for (auto* list : {&shifts, &turns}) {
      std::sort(list->begin(), list->end());
      for (size_t i = 1; i < 9; ++i) EXPECT_NEAR((*list)[i] - (*list)[i - 1], 1.0f / 9, 1e-3f);
    }
  }
  EXPECT_EQ(spiral_start(uvec2(1, 1), 0, 5, false), spiral_start(uvec2(8, 3), 0, 5, false));
  EXPECT_NE(spiral_start(uvec2(1, 1), 0, 5, true), spiral_start(uvec2(1, 1), 0, 6, true));
}

TEST(Bilateral, TellsSurfacesApart) {
  const vec3 p(0, 0, -10), up(0, 0, 1);
  EXPECT_FLOAT_EQ(bilateral_weight(p, up, p + vec3(3, 2, 0), up, 0.02f), 1.0f) << "same plane";
  EXPECT_EQ(bilateral_weight(p, up, p + vec3(0, 0, -0.3f), up, 0.02f), 0.0f) << "behind";
  EXPECT_EQ(bilateral_weight(p, up, p, vec3(1, 0, 0), 0.02f), 0.0f) << "turned";
}

TEST(Packing, OctahedralNormalsComeBack) {
  for (int i = 0; i < 1000; ++i) {
    const double z = 1 - 2 * (i + 0.5) / 1000, phi = i * 2.399963;
    const double s = std::sqrt(1 - z * z);
    const vec3 n(s * std::cos(phi), s * std::sin(phi), z);
    const vec2 packed = octahedral_encode(n);
    EXPECT_LE(std::max(std::abs(packed.x), std::abs(packed.y)), 1.0f);
    EXPECT_NEAR(glm::length(octahedral_decode(packed) - n), 0.0f, 1e-6f);
  }
  for (const vec3 axis : {vec3(0, 0, 1), vec3(0, 0, -1), vec3(1, 0, 0), vec3(0, -1, 0)})
    EXPECT_NEAR(glm::length(octahedral_decode(octahedral_encode(axis)) - axis), 0.0f, 1e-6f);
}

}  // namespace
}  // namespace lueur
