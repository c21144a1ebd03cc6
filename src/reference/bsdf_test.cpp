// SPDX-License-Identifier: MIT
// The lobes by themselves, against quadrature and each other.
#include "reference/bsdf.h"

#include <cmath>
#include <random>
#include <vector>

#include "reference/reference_fixture.h"
#include "reference/sampler.h"
#include "shading/brdf.h"

namespace lueur::reference {
namespace {

constexpr double kEyeAzimuth = 0.7;

struct Lobe {
  const char* name;
  BsdfParameters parameters;
};

BsdfParameters ggx(float roughness, float f0 = 1.0f, float f90 = 1.0f, float diffuse = 0.0f) {
  return {.diffuse_albedo = glm::vec3(diffuse),
          .specular_f0 = glm::vec3(f0),
          .specular_f90 = f90,
          .roughness = roughness};
}

BsdfParameters phong(float exponent, float c_xy = -1.0f, float c_z = 1.0f, float diffuse = 0.0f) {
  return {.diffuse_albedo = glm::vec3(diffuse),
          .phong = PhongLobe{glm::vec3(1.0f - diffuse), exponent, c_xy, c_z}};
}

const std::vector<Lobe> kLobes = {
    {"lambert", ggx(1.0f, 0.0f, 0.0f, 1.0f)},
    {"ggx rough", ggx(1.0f)},
    {"ggx half", ggx(0.5f)},
    {"ggx glossy", ggx(0.3f)},
    {"dielectric", ggx(0.4f, 0.04f, 1.0f, 0.8f)},
    {"phong 1", phong(1)},
    {"phong 10", phong(10)},
    {"phong 60 over diffuse", phong(60, -1, 1, 0.4f)},
    {"lafortune off-specular", phong(8, -1.0f, 0.6f)},
    {"lafortune flat", phong(8, -0.4f, 1.0f)},
    {"lafortune retro", phong(12, 1.0f, 1.0f, 0.2f)},
};

const double kEyeAngles[] = {0.0, 0.4, 0.9, 1.3, 1.5};

glm::vec3 direction(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

Bsdf towards(BsdfParameters parameters, double angle, float least_diffuse_share = 0.0f) {
  parameters.to_eye = direction(angle, kEyeAzimuth);
  return {parameters, least_diffuse_share};
}

// The integral over the hemisphere. The points crowd at the horizon and around the azimuth opposite
// to the eye's, where lobes are narrowest when the eye grazes the surface.
template <class F>
double hemisphere(const F& f) {
  static const Rule kRule = gauss_legendre(160);
  double sum = 0;
  for (size_t i = 0; i < kRule.at.size(); ++i) {
    const double down = 1 - kRule.at[i], theta = 0.5 * kPi * (1 - down * down);
    for (size_t j = 0; j < kRule.at.size(); ++j) {
      const double t = 2 * kRule.at[j] - 1, phi = kEyeAzimuth + kPi + kPi * t * t * t;
      // d theta = pi down, d phi = 6 pi t^2, by a step in the rule's variables.
      sum += kRule.weight[i] * kRule.weight[j] * down * 6 * t * t * std::sin(theta) *
             f(direction(theta, phi));
    }
  }
  return sum * kPi * kPi;
}

double f_cos(const Bsdf& bsdf, const glm::vec3& to_light) {
  const auto f =
      static_cast<double>(bsdf.diffuse().r) / kPi + static_cast<double>(bsdf.specular(to_light).r);
  return f * static_cast<double>(bsdf.cosine(to_light));
}

TEST(Bsdf, ReflectsAtMostWhatArrives) {
  for (const Lobe& lobe : kLobes)
    for (const double angle : kEyeAngles) {
      const Bsdf bsdf = towards(lobe.parameters, angle);
      const double albedo = hemisphere([&](const glm::vec3& l) { return f_cos(bsdf, l); });
      // The quadrature is good to 1e-4. glTF's dielectric adds
      // its lobes and so may exceed 1 at a grazing eye: diffuse 0.8 and up to 1 of the specular.
      const double most = std::string(lobe.name) == "dielectric" ? 1.8 : 1.0;
      EXPECT_LE(albedo, most + 1e-4) << lobe.name << " from " << angle;
      EXPECT_GT(albedo, 0.0) << lobe.name << " from " << angle;
    }
}

// What a lobe reflects of light along its own axis is its colour: the norm of scene.h.
TEST(Bsdf, PhongIsNormalised) {
  for (const float exponent : {1.0f, 8.0f, 50.0f})
    for (const float c_xy : {-1.0f, -0.5f, 1.0f}) {
      const Bsdf bsdf = towards(phong(exponent, c_xy), 0.0);
      EXPECT_NEAR(hemisphere([&](const glm::vec3& l) { return f_cos(bsdf, l); }), 1.0, 1e-4);
    }
}

TEST(Bsdf, LambertIsNormalised) {
  const Bsdf bsdf = towards(ggx(1.0f, 0.0f, 0.0f, 0.7f), 1.0);
  EXPECT_NEAR(hemisphere([&](const glm::vec3& l) { return f_cos(bsdf, l); }), 0.7, 1e-6);
}

TEST(Bsdf, IsReciprocal) {
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const Lobe& lobe : kLobes)
    for (int k = 0; k < 200; ++k) {
      // Up to 85 degrees: flatter, the renderer bounds the eye's cosine and not the light's.
      const glm::vec3 a = direction(1.48 * unit(engine), 2 * kPi * unit(engine));
      const glm::vec3 b = direction(1.48 * unit(engine), 2 * kPi * unit(engine));
      BsdfParameters from = lobe.parameters, to = lobe.parameters;
      from.to_eye = a;
      to.to_eye = b;
      const float there = Bsdf(from, 0.0f).specular(b).r, back = Bsdf(to, 0.0f).specular(a).r;
      EXPECT_NEAR(there, back, 1e-4f * std::max(there, 1e-3f)) << lobe.name;
    }
}

// Of directions, as many as its density says are found; those that would go below the horizon are
// lost, so the density integrates to the share that is not.
TEST(Bsdf, DensityIntegratesToTheShareOfDirectionsFound) {
  constexpr uint32_t kSamples = 1u << 14;
  for (const Lobe& lobe : kLobes)
    for (const double angle : kEyeAngles)
      for (const float least : {0.0f, 0.5f}) {
        const Bsdf bsdf = towards(lobe.parameters, angle, least);
        const double integral =
            hemisphere([&](const glm::vec3& l) { return static_cast<double>(bsdf.pdf(l)); });
        uint32_t found = 0;
        for (uint32_t i = 0; i < kSamples; ++i) {
          Sampler sampler(99, i);
          found += bsdf.sample(sampler.next_2d()).pdf > 0.0f ? 1 : 0;
        }
        // The boundary of what is lost is a curve in the unit square, which at most a few times
        // sqrt(n) of n stratified samples are near to: 4 / sqrt(n) bounds the error.
        EXPECT_NEAR(integral, static_cast<double>(found) / kSamples, 4.0 / std::sqrt(kSamples))
            << lobe.name << " from " << angle << ", diffuse at least " << least;
        EXPECT_LE(integral, 1.0 + 1e-4) << lobe.name << " from " << angle;
      }
}

TEST(Bsdf, NothingIsLostWhereTheLobeIsAboveTheHorizon) {
  for (const BsdfParameters& p : {ggx(1.0f, 0.0f, 0.0f, 1.0f), phong(1), phong(30, -0.3f)}) {
    const Bsdf bsdf = towards(p, 0.0);
    EXPECT_NEAR(hemisphere([&](const glm::vec3& l) { return static_cast<double>(bsdf.pdf(l)); }),
                1.0, 1e-4);
  }
}

TEST(Bsdf, SamplesHaveTheDensityTheyName) {
  for (const Lobe& lobe : kLobes) {
    const Bsdf bsdf = towards(lobe.parameters, 0.9, 0.3f);
    for (uint32_t i = 0; i < 64; ++i) {
      Sampler sampler(5, i);
      const Bsdf::Sample sample = bsdf.sample(sampler.next_2d());
      if (!(sample.pdf > 0.0f)) continue;
      EXPECT_NEAR(glm::length(sample.to_light), 1.0f, 1e-5f) << lobe.name;
      EXPECT_EQ(sample.pdf, bsdf.pdf(sample.to_light)) << lobe.name;
    }
  }
}

// The mean of g / pdf over sampled directions is the integral of g, for a g with no symmetry: with
// 32 random seeds it has to be within five standard errors.
TEST(Bsdf, SampledEstimatesEqualQuadrature) {
  constexpr uint32_t kSeeds = 32, kSamples = 512;
  for (const Lobe& lobe : kLobes)
    for (const double angle : kEyeAngles)
      for (const float least : {0.0f, 0.5f}) {
        const Bsdf bsdf = towards(lobe.parameters, angle, least);
        const auto g = [&](const glm::vec3& l) {
          return f_cos(bsdf, l) * static_cast<double>(2.0f + l.x - 0.5f * l.y);
        };
        double sum = 0, squares = 0;
        for (uint32_t seed = 0; seed < kSeeds; ++seed) {
          double mean = 0;
          for (uint32_t i = 0; i < kSamples; ++i) {
            Sampler sampler(combined(seed, 77), i);
            const Bsdf::Sample s = bsdf.sample(sampler.next_2d());
            if (s.pdf > 0.0f) mean += g(s.to_light) / static_cast<double>(s.pdf) / kSamples;
          }
          sum += mean;
          squares += mean * mean;
        }
        const double mean = sum / kSeeds;
        const double error = std::sqrt((squares / kSeeds - mean * mean) / (kSeeds - 1));
        EXPECT_NEAR(mean, hemisphere(g), 5.0 * error + 2e-5)
            << lobe.name << " from " << angle << ", diffuse at least " << least;
      }
}

// One formula, two homes: with the eye and light in any frame it is shading/brdf.h's.
TEST(Bsdf, GgxIsTheRenderers) {
  std::mt19937 engine(3);
  std::uniform_real_distribution<float> unit(0, 1);
  for (int k = 0; k < 500; ++k) {
    const auto random_direction = [&] {
      return direction(1.5 * static_cast<double>(unit(engine)),
                       6.28 * static_cast<double>(unit(engine)));
    };
    const Frame turned(glm::normalize(glm::vec3(unit(engine), unit(engine), unit(engine)) - 0.5f));
    const glm::vec3 eye = turned.to_world(random_direction());
    const glm::vec3 light = turned.to_world(random_direction());
    const glm::vec3 f0(unit(engine), unit(engine), unit(engine));
    const float roughness = unit(engine), f90 = unit(engine);
    const glm::vec3 half_way = glm::normalize(eye + light);
    const glm::vec3 expected =
        ggx_brdf(f0, f90, roughness, glm::dot(turned.z, light), glm::dot(turned.z, eye),
                 glm::dot(turned.z, half_way), glm::dot(light, half_way));
    const Bsdf bsdf({.normal = turned.z,
                     .to_eye = eye,
                     .specular_f0 = f0,
                     .specular_f90 = f90,
                     .roughness = roughness},
                    0.0f);
    const glm::vec3 found = bsdf.specular(light);
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(found[c], expected[c], 1e-3f * std::max(expected[c], 1e-3f));
  }
}

TEST(Bsdf, NothingFromBelow) {
  for (const Lobe& lobe : kLobes) {
    const Bsdf bsdf = towards(lobe.parameters, 0.5);
    const glm::vec3 below = direction(1.7, 1.0);
    EXPECT_EQ(bsdf.specular(below), glm::vec3(0.0f));
    EXPECT_EQ(bsdf.pdf(below), 0.0f);
    EXPECT_EQ(bsdf.cosine(below), 0.0f);
  }
}

TEST(Bsdf, FramesAreOrthonormal) {
  std::mt19937 engine(5);
  std::normal_distribution<float> normal;
  for (int k = 0; k < 1000; ++k) {
    glm::vec3 z = glm::normalize(glm::vec3(normal(engine), normal(engine), normal(engine)));
    if (k == 0) z = {0, 0, -1};
    const Frame f(z);
    EXPECT_NEAR(glm::dot(f.x, f.y), 0.0f, 1e-6f);
    EXPECT_NEAR(glm::dot(f.x, f.z), 0.0f, 1e-6f);
    EXPECT_NEAR(glm::dot(glm::cross(f.x, f.y), f.z), 1.0f, 1e-5f);
  }
}

}  // namespace
}  // namespace lueur::reference
