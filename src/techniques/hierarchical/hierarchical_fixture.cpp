// SPDX-License-Identifier: MIT
#include "techniques/hierarchical/hierarchical_fixture.h"

#include <cmath>
#include <glm/gtc/type_ptr.hpp>

namespace lueur {
namespace {

std::vector<glm::dvec3> colors_of(const Pixels& p) {
  std::vector<glm::dvec3> light;
  for (size_t i = 0; i + 3 < p.samples.size(); i += 4)
    light.emplace_back(p.samples[i], p.samples[i + 1], p.samples[i + 2]);
  return light;
}

}  // namespace

HierarchicalTest::Light HierarchicalTest::diffuse(const CpuGBuffer& g, const Settings& settings,
                                                  uint32_t seed) {
  Hierarchical technique(settings);
  return next_frame(technique, g, {.seed = seed, .cut = true}).diffuse;
}

HierarchicalTest::Frames HierarchicalTest::next_frame(Hierarchical& technique, const CpuGBuffer& g,
                                                      Inputs inputs) {
  bool has_specular = false;
  run([&](Frame& frame) {
    inputs.view = g.view;
    inputs.g_buffer = g.upload(frame.recorder());
    const Outputs out = technique.render(frame, inputs);
    frame.recorder().read_back("diffuse", out.diffuse);
    has_specular = out.specular.valid();
    if (has_specular) frame.recorder().read_back("specular", out.specular);
  });
  Frames frames{.diffuse = colors_of(pixels("diffuse")), .specular = {}};
  if (has_specular) frames.specular = colors_of(pixels("specular"));
  return frames;
}

HierarchicalSettings exhaustive() {
  using Settings = HierarchicalSettings;
  Settings s;
  s.start = Settings::Start::full;
  s.levels = 1;
  s.radius = 4096;
  s.sampling = Settings::Sampling::every_pixel;
  s.filter = false;
  return s;
}

std::optional<CpuHit> corner_room(const glm::dvec3& o, const glm::dvec3& d) {
  std::optional<CpuHit> best;
  double nearest = 1e30;
  const auto plane = [&](glm::dvec3 n, double at, glm::dvec3 radiance) {
    const double facing = glm::dot(n, d);
    if (facing >= 0) return;
    const double t = (at - glm::dot(n, o)) / facing;
    if (t <= 1e-9 || t >= nearest) return;
    nearest = t;
    best = CpuHit{o + t * d, n, radiance};
  };
  plane({0, 1, 0}, -1.0, {0.2, 0.2, 0.2});
  plane({0, 0, 1}, -5.0, {1.0, 0.6, 0.3});
  plane({1, 0, 0}, -2.0, {0.1, 0.8, 0.2});
  const glm::dvec3 centre(0.4, -0.4, -3.4);
  const double radius = 0.6, b = glm::dot(d, o - centre), a = glm::dot(d, d);
  const double root = b * b - a * (glm::dot(o - centre, o - centre) - radius * radius);
  if (root > 0) {
    const double t = (-b - std::sqrt(root)) / a;
    if (t > 1e-9 && t < nearest) {
      const glm::dvec3 p = o + t * d;
      best = CpuHit{p, (p - centre) / radius, {0.5, 0.1, 2.0}};
    }
  }
  return best;
}

std::optional<CpuHit> striped_sphere(const glm::dvec3&, const glm::dvec3& d) {
  const glm::dvec3 n = glm::normalize(d);
  return CpuHit{2.0 * n, -n, glm::dvec3(std::sin(12 * n.x) * std::sin(12 * n.y) > 0 ? 1.0 : 0.0)};
}

std::optional<CpuHit> white_sphere(const glm::dvec3&, const glm::dvec3& d) {
  const glm::dvec3 n = glm::normalize(d);
  return CpuHit{2.0 * n, -n, glm::dvec3(1.0)};
}

double relative_rmse(const std::vector<glm::dvec3>& a, const std::vector<glm::dvec3>& truth) {
  double error = 0, power = 0;
  for (size_t i = 0; i < truth.size(); ++i) {
    error += glm::dot(a[i] - truth[i], a[i] - truth[i]);
    power += glm::dot(truth[i], truth[i]);
  }
  return std::sqrt(error / power);
}

}  // namespace lueur
