// SPDX-License-Identifier: MIT
// For the reference's tests: renderings, closed forms, and how estimates must scatter around them.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "reference/reference.h"
#include "support/test_scene.h"

namespace lueur::reference {

inline constexpr double kPi = std::numbers::pi;
// For estimates(): few pixels, many seeds.
inline constexpr Shot kShot{24, 24};
inline constexpr int kSeedCount = 64;

// A Lambert surface that the camera sees from both sides. Returns the material.
int32_t add_diffuse(Scene& scene, float albedo, float emission = 0.0f);

// The inside of a closed sphere or cube around the origin of radius or half side 1, with the camera
// in it, off the centre. Material 0 is its own, and white.
enum class Facets { flat, smooth };  // 32 of them around
Scene inside_sphere(Facets facets = Facets::flat);
Scene inside_box();

// Renders, and fails the test if that fails.
Rendering rendered(const Scene& scene, const Shot& shot, const Settings& settings,
                   const Control& control = {}, std::span<const uint8_t> resume_from = {});
// The layer, which has to be there.
const ImageF& layer(const Rendering& rendering, const std::string& name);
// Of a rendering that goes away, a layer that does not.
ImageF layer(Rendering&& rendering, const std::string& name);
// Whether both have the same layers, bit for bit.
bool same_layers(const Rendering& a, const Rendering& b);

// One ray for each pixel's centre.
std::vector<PixelRay> rays_of(const Scene& scene, const Shot& shot);

// The share of a point's cosine-weighted hemisphere that a polygon above its horizon covers: E /
// (pi L) under a polygon of radiance L, by Lambert's sum over its edges.
double polygon_share(const glm::dvec3& point, const glm::dvec3& normal,
                     const std::vector<glm::dvec3>& polygon);
// Corners of the parallelogram of add_quad().
std::vector<glm::dvec3> quad_corners(const glm::dvec3& corner, const glm::dvec3& u,
                                     const glm::dvec3& v);

// Abscissas in (0, 1) and weights of Gauss and Legendre's rule with `n` points.
struct Rule {
  std::vector<double> at, weight;
};
Rule gauss_legendre(int n);

// A pixel's mean over renderings of different seeds, and the standard error of that mean by how
// they differ. First channel of one layer. Settings::seed is the first of the seeds.
struct Estimates {
  int seeds = 0;
  std::vector<double> mean, error;
};
Estimates estimates(const Scene& scene, const Shot& shot, Settings settings, int seeds,
                    const std::string& layer_name = "indirect");
// The same of two layers, from the same renderings.
std::pair<Estimates, Estimates> estimates_of_both(const Scene& scene, const Shot& shot,
                                                  Settings settings, int seeds,
                                                  const std::string& first,
                                                  const std::string& second);

// Expects z = (mean - exact) / error of all pixels to be distributed as chance alone would have it;
// see the source for the bounds. `exact` is asked for each pixel; none: the pixel is left out.
void expect_unbiased(const Estimates& found,
                     const std::function<std::optional<double>(size_t pixel)>& exact);
// The same for the difference of two independent estimates.
void expect_same(const Estimates& a, const Estimates& b);

}  // namespace lueur::reference
