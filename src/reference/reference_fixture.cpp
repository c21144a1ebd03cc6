// SPDX-License-Identifier: MIT
#include "reference/reference_fixture.h"

#include <cmath>
#include <cstring>

#include "scene/builtin/scene_builder.h"
#include "scene/builtin/shapes.h"

namespace lueur::reference {
namespace {

// Of a pixel's mean over its seeds: the estimates are floats and so are their sums.
constexpr double kRounding = 4e-7;

// Gives each triangle corners of its own with its own normal. Interpolated normals lean out of the
// triangles' planes, and light from below those is lost.
void flatten(Mesh& mesh) {
  std::vector<Vertex> vertices;
  for (const uint32_t index : mesh.indices) vertices.push_back(mesh.vertices[index]);
  for (size_t k = 0; k < vertices.size(); k += 3) {
    const glm::vec3 a = vertices[k].position;
    const glm::vec3 normal =
        glm::normalize(glm::cross(vertices[k + 1].position - a, vertices[k + 2].position - a));
    for (size_t c = 0; c < 3; ++c) vertices[k + c].normal = normal;
  }
  for (size_t k = 0; k < vertices.size(); ++k) mesh.indices[k] = static_cast<uint32_t>(k);
  mesh.vertices = std::move(vertices);
}

Scene inside(bool is_flat, const std::function<void(builtin::MeshBuilder&)>& add) {
  Scene scene = scene_seen_from({0.3f, 0.1f, 0.2f}, {-1, -0.4f, -0.8f});
  scene.materials[0].specular = 0.0f;
  scene.materials[0].double_sided = true;
  builtin::MeshBuilder builder;
  add(builder);
  Mesh shell = builder.finish("shell");
  if (is_flat) flatten(shell);
  builtin::add_mesh(scene, std::move(shell));
  return scene;
}

// Sums over seeds of one layer's first channel.
struct Sums {
  std::vector<double> sum, squares;
  void add(const ImageF& image) {
    const size_t pixels = size_t{image.width} * image.height;
    sum.resize(pixels);
    squares.resize(pixels);
    for (size_t i = 0; i < pixels; ++i) {
      const auto value = static_cast<double>(image.samples[i * image.channels]);
      sum[i] += value;
      squares[i] += value * value;
    }
  }
  Estimates estimates(int seeds) const {
    Estimates e{seeds, {}, {}};
    for (size_t i = 0; i < sum.size(); ++i) {
      const double mean = sum[i] / seeds;
      const double variance = std::max(squares[i] - seeds * mean * mean, 0.0) / (seeds - 1);
      e.mean.push_back(mean);
      e.error.push_back(std::sqrt(variance / seeds));
    }
    return e;
  }
};

// The least k that a Poisson variable of this mean exceeds with a probability below 1e-6.
int poisson_bound(double mean) {
  double term = std::exp(-mean), below = term;
  int k = 0;
  while (1.0 - below > 1e-6) {
    ++k;
    term *= mean / k;
    below += term;
  }
  return k;
}

// A pixel's estimate is a mean of many paths, nearly normal, so its z follows Student's t with
// nu = seeds - 1 degrees of freedom, independently of other pixels':
//   E z = 0, Var z = E z^2 = nu / (nu - 2), Var z^2 = 3 nu^2 / ((nu - 2)(nu - 4)) - (E z^2)^2,
//   P(|z| > 3) < 0.0054 for nu >= 31.
// The means of z and of z^2 over the pixels may be five of their standard deviations off, which
// happens by chance less than once in a million; as many |z| > 3 are allowed as a Poisson variable
// reaches once in a million. A bias of a fifth of one pixel's standard error in all of 576 pixels
// shows in the first, errors in single pixels in the third, correlated seeds in the second.
void expect_like_chance(const std::vector<double>& z, double nu) {
  ASSERT_GE(nu, 31.0);
  ASSERT_GE(z.size(), 50u) << "too few pixels to tell";
  const auto n = static_cast<double>(z.size());
  double sum = 0, squares = 0;
  int beyond = 0;
  for (const double value : z) {
    sum += value;
    squares += value * value;
    beyond += std::abs(value) > 3.0 ? 1 : 0;
  }
  const double variance = nu / (nu - 2);
  const double spread = std::sqrt(3 * nu * nu / ((nu - 2) * (nu - 4)) - variance * variance);
  testing::Test::RecordProperty("mean_z", std::to_string(sum / n));
  testing::Test::RecordProperty("mean_z2_over_expected", std::to_string(squares / n / variance));
  testing::Test::RecordProperty("beyond_3_of",
                                std::to_string(beyond) + " of " + std::to_string(z.size()));
  EXPECT_NEAR(sum / n, 0.0, 5.0 * std::sqrt(variance / n)) << "bias, in standard errors";
  EXPECT_NEAR(squares / n, variance, 5.0 * spread / std::sqrt(n)) << "mean of z^2";
  EXPECT_LE(beyond, poisson_bound(0.0054 * n)) << "of " << n << " pixels are 3 errors off";
}

}  // namespace

int32_t add_diffuse(Scene& scene, float albedo, float emission) {
  const int32_t index = builtin::add_material(scene, "diffuse", glm::vec3(albedo));
  Material& material = scene.materials.back();
  material.specular = 0.0f;
  material.double_sided = true;
  material.emission = glm::vec3(emission);
  return index;
}

Scene inside_sphere(Facets facets) {
  return inside(facets == Facets::flat,
                [](builtin::MeshBuilder& b) { builtin::add_sphere(b, glm::vec3(0.0f), 1.0f, 32); });
}

Scene inside_box() {
  return inside(true, [](builtin::MeshBuilder& b) {
    builtin::add_box(b, glm::vec3(-1.0f), glm::vec3(1.0f), {.edge_m = 2.0f});
  });
}

Rendering rendered(const Scene& scene, const Shot& shot, const Settings& settings,
                   const Control& control, std::span<const uint8_t> resume_from) {
  auto rendering = render(scene, shot, settings, control, resume_from);
  EXPECT_TRUE(rendering.ok()) << rendering.error().message;
  return rendering.ok() ? std::move(*rendering) : Rendering{};
}

const ImageF& layer(const Rendering& rendering, const std::string& name) {
  static const ImageF kNothing;
  const ImageF* found = find_layer(rendering, name);
  EXPECT_NE(found, nullptr) << "there is no layer '" << name << "'";
  return found ? *found : kNothing;
}

ImageF layer(Rendering&& rendering, const std::string& name) {
  return layer(static_cast<const Rendering&>(rendering), name);
}

bool same_layers(const Rendering& a, const Rendering& b) {
  if (a.layers.size() != b.layers.size() || a.layers.empty()) return false;
  for (const ImageLayer& l : a.layers) {
    const ImageF* other = find_layer(b, l.name);
    if (!other || other->samples.size() != l.image.samples.size() ||
        std::memcmp(other->samples.data(), l.image.samples.data(),
                    other->samples.size() * sizeof(float)) != 0)
      return false;
  }
  return true;
}

std::vector<PixelRay> rays_of(const Scene& scene, const Shot& shot) {
  const Camera& camera = scene.cameras[static_cast<size_t>(shot.camera)];
  const glm::mat4 world = pose(scene, shot.time_s)[static_cast<size_t>(camera.node)];
  return pixel_rays(camera, glm::dmat4(world), shot.width, shot.height);
}

double polygon_share(const glm::dvec3& point, const glm::dvec3& normal,
                     const std::vector<glm::dvec3>& polygon) {
  double sum = 0;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec3 a = glm::normalize(polygon[i] - point);
    const glm::dvec3 b = glm::normalize(polygon[(i + 1) % polygon.size()] - point);
    const glm::dvec3 across = glm::cross(a, b);
    const double sine = glm::length(across);
    if (sine > 0) sum += std::atan2(sine, glm::dot(a, b)) * glm::dot(across / sine, normal);
  }
  return std::abs(sum) / (2 * kPi);
}

std::vector<glm::dvec3> quad_corners(const glm::dvec3& corner, const glm::dvec3& u,
                                     const glm::dvec3& v) {
  return {corner, corner + u, corner + u + v, corner + v};
}

Rule gauss_legendre(int n) {
  Rule rule;
  for (int i = 0; i < n; ++i) {
    // Newton's iteration on the Legendre polynomial, from Tricomi's approximation of its root.
    double x = std::cos(kPi * (i + 0.75) / (n + 0.5)), slope = 0;
    for (int step = 0; step < 100; ++step) {
      double before = 1, now = x;
      for (int k = 2; k <= n; ++k) {
        const double next = ((2 * k - 1) * x * now - (k - 1) * before) / k;
        before = now;
        now = next;
      }
      slope = n * (x * now - before) / (x * x - 1);
      const double move = now / slope;
      x -= move;
      if (std::abs(move) < 1e-15) break;
    }
    rule.at.push_back(0.5 * (1 + x));
    rule.weight.push_back(1 / ((1 - x * x) * slope * slope));
  }
  return rule;
}

std::pair<Estimates, Estimates> estimates_of_both(const Scene& scene, const Shot& shot,
                                                  Settings settings, int seeds,
                                                  const std::string& first,
                                                  const std::string& second) {
  Sums sums[2];
  const uint32_t first_seed = settings.seed;
  for (int seed = 0; seed < seeds; ++seed) {
    // Hashes of neighbouring seeds are as good as any; these are merely not 0, 1, 2 …
    settings.seed = first_seed + 7919u * static_cast<uint32_t>(seed);
    const Rendering rendering = rendered(scene, shot, settings);
    sums[0].add(layer(rendering, first));
    sums[1].add(layer(rendering, second));
  }
  return {sums[0].estimates(seeds), sums[1].estimates(seeds)};
}

Estimates estimates(const Scene& scene, const Shot& shot, Settings settings, int seeds,
                    const std::string& layer_name) {
  return estimates_of_both(scene, shot, settings, seeds, layer_name, layer_name).first;
}

void expect_unbiased(const Estimates& found,
                     const std::function<std::optional<double>(size_t pixel)>& exact) {
  std::vector<double> z;
  double all_off = 0, all_exact = 0, variance = 0;
  for (size_t i = 0; i < found.mean.size(); ++i) {
    const std::optional<double> truth = exact(i);
    if (!truth) continue;
    all_off += found.mean[i] - *truth;
    all_exact += *truth;
    variance += found.error[i] * found.error[i];
    const double rounding = kRounding * std::abs(*truth);
    // Where every seed gave the same, that has to be it.
    if (found.error[i] <= rounding) {
      EXPECT_NEAR(found.mean[i], *truth, 4.0 * rounding) << "pixel " << i;
    } else {
      z.push_back((found.mean[i] - *truth) / found.error[i]);
    }
  }
  // For the tables of README.md.
  testing::Test::RecordProperty("relative_bias", std::to_string(all_off / all_exact));
  testing::Test::RecordProperty("its_error", std::to_string(std::sqrt(variance) / all_exact));
  expect_like_chance(z, found.seeds - 1);
}

// The degrees of freedom lie between seeds - 1 and twice that, by how much the variances of the two
// differ (Welch and Satterthwaite); the ends are 0.02 of E z^2 apart for 64 seeds, a third of its
// standard deviation for 576 pixels.
void expect_same(const Estimates& a, const Estimates& b) {
  ASSERT_EQ(a.mean.size(), b.mean.size());
  ASSERT_EQ(a.seeds, b.seeds);
  std::vector<double> z;
  for (size_t i = 0; i < a.mean.size(); ++i) {
    const double error = std::hypot(a.error[i], b.error[i]);
    if (error > kRounding * std::abs(a.mean[i])) {
      z.push_back((a.mean[i] - b.mean[i]) / error);
    } else {
      EXPECT_NEAR(a.mean[i], b.mean[i], 4.0 * kRounding * std::abs(a.mean[i])) << "pixel " << i;
    }
  }
  expect_like_chance(z, 1.5 * (a.seeds - 1));
}

}  // namespace lueur::reference
