// SPDX-License-Identifier: MIT
// Glossy receivers, FDP 4: against a sum over all pixels in double precision, and what drawing
// samples around the lobe's peak saves.
#include <cmath>

#include "techniques/hierarchical/equations.h"
#include "techniques/hierarchical/hierarchical_fixture.h"

namespace lueur {
namespace {

constexpr Extent kExtent{96, 72};
constexpr double kFov = 1.1;

// A floor that reflects and a wall behind it that shines in stripes of three colours.
std::optional<CpuHit> floor_and_wall(const glm::dvec3& o, const glm::dvec3& d) {
  constexpr double kBack = -3.0;
  const double t_wall = d.z < 0 ? (kBack - o.z) / d.z : 1e30;
  const double t_floor = d.y < 0 ? -o.y / d.y : 1e30;
  if (t_floor < t_wall) return CpuHit{o + t_floor * d, {0, 1, 0}, glm::dvec3(0)};
  if (t_wall > 1e29) return std::nullopt;
  const glm::dvec3 p = o + t_wall * d;
  if (p.y > 1.5) return std::nullopt;
  glm::dvec3 radiance(0.05);
  radiance[(static_cast<int>(std::floor(p.x / 0.7)) % 3 + 3) % 3] = 1.0;
  return CpuHit{p, {0, 0, 1}, radiance};
}

class GlossyTest : public HierarchicalTest {
 protected:
  GlossyTest() {
    g_ = cast_g_buffer(floor_and_wall, kExtent, kFov, {0, 1.0, 1.0});
    g_.reflectance.assign(g_.depth.size(), glm::vec4(0));
    settings_.start = Settings::Start::full;
    settings_.levels = 1;
    settings_.radius = 60;
    settings_.filter = false;
    settings_.temporal = 0;
    settings_.glossy = true;
    settings_.glossy_samples = 64;
  }

  void floor_reflects(const glm::vec4& reflectance) {
    for (size_t i = 0; i < g_.depth.size(); ++i)
      if (g_.normal[i].y > 0.5f) g_.reflectance[i] = reflectance;
  }

  Light mean_of(uint32_t frames) {
    Light mean(g_.depth.size(), glm::dvec3(0));
    Hierarchical technique(settings_);
    for (uint32_t i = 0; i < frames; ++i) {
      const Light light = next_frame(technique, g_, {.seed = i, .lobes = lobes_}).specular;
      for (size_t k = 0; k < mean.size(); ++k) mean[k] += light[k] / double(frames);
    }
    return mean;
  }

  // Sum of f L cos cos' ds / r^2 over all pixels within the radius, f being the lobe's. Of the
  // floor's pixels for which the radius holds all of the wall's reflection.
  template <class Lobe>
  double error_of(const Light& ours, Lobe f) {
    const double tan_v = std::tan(kFov / 2), tan_h = tan_v * kExtent.width / kExtent.height;
    double error = 0, power = 0;
    for (int y = 0; y < int(kExtent.height); ++y) {
      for (int x = 0; x < int(kExtent.width); ++x) {
        const size_t at = size_t(y) * kExtent.width + size_t(x);
        if (g_.depth[at] == 0 || g_.normal[at].y < 0.5f) continue;
        const glm::dvec3 p = g_.position_view[at], n(0, 1, 0), to_eye = -glm::normalize(p);
        // A sample stands for a patch 0.2 m wide, which has to be small against its distance.
        if (p.z + 1.0 < -3.0 + 1.0) continue;
        glm::dvec3 sum(0);
        for (int v = 0; v < int(kExtent.height); ++v) {
          for (int u = 0; u < int(kExtent.width); ++u) {
            const size_t j = size_t(v) * kExtent.width + size_t(u);
            if (g_.depth[j] == 0 || g_.source[j] == glm::vec3(0)) continue;
            if (std::hypot(u - x, v - y) > 60) continue;
            const glm::dvec3 q = g_.position_view[j], d = q - p;
            const double r = glm::length(d), z = -q.z;
            const double foreshortening = z / glm::dot(glm::dvec3(g_.normal[j]), -q);
            const double ds =
                z * z * 4 * tan_h * tan_v / (kExtent.width * kExtent.height) * foreshortening;
            const double cos_there = -glm::dot(glm::dvec3(g_.normal[j]), d) / r;
            const double cos_here = glm::dot(n, d) / r;
            if (cos_here <= 0 || cos_there <= 0) continue;
            sum += glm::dvec3(g_.source[j]) *
                   (f(n, d / r, to_eye) * cos_here * cos_there * ds / (r * r));
          }
        }
        error += glm::dot(ours[at] - sum, ours[at] - sum);
        power += glm::dot(sum, sum);
      }
    }
    return std::sqrt(error / power);
  }

  CpuGBuffer g_;
  Settings settings_;
  std::vector<CosineLobe> lobes_;
};

double phong(double exponent, const glm::dvec3& n, const glm::dvec3& l, const glm::dvec3& v) {
  const glm::dvec3 mirrored = 2 * glm::dot(n, v) * n - v;
  return (exponent + 2) / (2 * kPi) * std::pow(std::max(glm::dot(mirrored, l), 0.0), exponent);
}

// With either way of drawing the mean is the sum, as far as a lobe is wide against the patches that
// samples stand for: narrower ones are widened. Evenly drawn patches are four times as large.
TEST_F(GlossyTest, PhongLobesGiveTheSumOverAllPixels) {
  lobes_ = {{.exponent = 5, .c_xy = -1, .c_z = 1}};
  floor_reflects({1, 1, 1, -1});
  for (const bool importance : {true, false}) {
    settings_.glossy_importance = importance;
    settings_.glossy_samples = 256;
    EXPECT_LT(error_of(mean_of(32), [](auto n, auto l, auto v) { return phong(5, n, l, v); }), 0.05)
        << (importance ? "by the lobe" : "evenly");
  }
}

TEST_F(GlossyTest, LafortuneLobesAreThoseOfTheirCoefficients) {
  lobes_ = {{}, {.exponent = 12, .c_xy = -0.9f, .c_z = 0.6f}};
  floor_reflects({1, 1, 1, -2});
  settings_.glossy_samples = 256;
  const auto lobe = [](const glm::dvec3& n, const glm::dvec3& l, const glm::dvec3& v) {
    const double along = glm::dot(n, l) * glm::dot(n, v);
    const double sum = -0.9 * (glm::dot(l, v) - along) + 0.6 * along;
    return 14 / (2 * kPi) * std::pow(std::max(sum, 0.0) / 0.9, 12);
  };
  EXPECT_LT(error_of(mean_of(32), lobe), 0.05);
}

// F0 = 1 leaves Fresnel nothing to add: D V alone.
TEST_F(GlossyTest, GgxGivesTheSumOverAllPixels) {
  constexpr double kRoughness = 0.6, kAlpha2 = kRoughness * kRoughness * kRoughness * kRoughness;
  floor_reflects({1, 1, 1, float(kRoughness)});
  settings_.glossy_samples = 256;
  const auto ggx = [](const glm::dvec3& n, const glm::dvec3& l, const glm::dvec3& v) {
    const glm::dvec3 h = glm::normalize(l + v);
    const double nh = glm::dot(n, h), nl = glm::dot(n, l), nv = glm::dot(n, v);
    const double d = kAlpha2 / (kPi * std::pow(nh * nh * (kAlpha2 - 1) + 1, 2));
    return d * 0.5 /
           (nl * std::sqrt(nv * nv * (1 - kAlpha2) + kAlpha2) +
            nv * std::sqrt(nl * nl * (1 - kAlpha2) + kAlpha2));
  };
  EXPECT_LT(error_of(mean_of(32), ggx), 0.05);
}

// FDP figure 3, exponent 128: as many samples, drawn around the lobe, leave half of the error. It
// takes four times as many evenly drawn ones to get there; of twice as many the ratio would be 1.4.
TEST_F(GlossyTest, DrawingByTheLobeLowersTheError) {
  lobes_ = {{.exponent = 128}};
  floor_reflects({1, 1, 1, -1});
  const Light truth = mean_of(128);
  const double drawn = relative_rmse(mean_of(1), truth);
  settings_.glossy_importance = false;
  const double even = relative_rmse(mean_of(1), mean_of(128));
  RecordProperty("error_even_over_drawn", std::to_string(even / drawn));
  EXPECT_GT(even, 1.4 * drawn);
}

TEST(GlossyAzimuth, DensityIntegratesToOneAndSamplesFollowIt) {
  for (const float exponent : {1.0f, 8.0f, 128.0f, 5000.0f}) {
    const GlossyAzimuth f = glossy_azimuth(exponent);
    double integral = 0;
    constexpr int kSteps = 20'000;
    for (int i = 0; i < kSteps; ++i)
      integral += double{glossy_density(f, float((i + 0.5) / kSteps - 0.5) * kTurn)} *
                  double{kTurn} / kSteps;
    EXPECT_NEAR(integral, 1.0, 1e-3) << exponent;
    // The share of samples within an angle is the integral of the density up to there.
    for (const double angle : {0.05, 0.3, 1.0}) {
      double inside = 0, expected = 0;
      for (int i = 0; i < kSteps; ++i) {
        inside += std::abs(double{glossy_sample(f, (float(i) + 0.5f) / kSteps)}) < angle;
        expected += double{glossy_density(f, float((i + 0.5) / kSteps * angle))} * 2 * angle;
      }
      EXPECT_NEAR(inside / kSteps, expected / kSteps, 2e-3) << exponent << " within " << angle;
    }
  }
}

}  // namespace
}  // namespace lueur
