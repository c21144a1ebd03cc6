// SPDX-License-Identifier: MIT
#include "reference/screen_sum.h"

#include <algorithm>
#include <numeric>

#include "shading/brdf.h"
#include "shading/form_factor.h"

namespace lueur::reference {

ScreenSum::ScreenSum(const std::vector<std::optional<FirstHit>>& hits, const ImageF& source,
                     const PinholeCamera& camera, const Settings& settings)
    : seed_(settings.seed), form_factor_(settings.form_factor) {
  const glm::vec3 right = camera.step_x() / glm::dot(camera.step_x(), camera.step_x());
  const glm::vec3 down = camera.step_y() / glm::dot(camera.step_y(), camera.step_y());
  for (size_t i = 0; i < hits.size(); ++i) {
    const glm::vec3 radiance(source.samples[3 * i], source.samples[3 * i + 1],
                             source.samples[3 * i + 2]);
    if (!hits[i] || radiance == glm::vec3(0.0f)) continue;
    const FirstHit& hit = *hits[i];
    // cos(alpha) / cos(beta) of HSSIL (2) wants the ray per unit of the axis, in view space.
    const glm::vec3 ray = (hit.surface.position - camera.eye()) / hit.z_m;
    const float length_x = glm::length(camera.step_x()), length_y = glm::length(camera.step_y());
    const glm::vec3 unit_right = right * length_x, unit_up = -down * length_y;
    const glm::vec3 normal_view(glm::dot(hit.surface.normal, unit_right),
                                glm::dot(hit.surface.normal, unit_up),
                                -glm::dot(hit.surface.normal, camera.axis()));
    const glm::vec2 ray_view(glm::dot(ray, unit_right), glm::dot(ray, unit_up));
    const float area = hit.z_m * hit.z_m * camera.pixel_area() *
                       foreshortening(normal_view, ray_view, kMostForeshortening);
    sources_.push_back({hit.surface.position, hit.surface.normal, area / kPi, radiance});
  }
  passes_ = static_cast<uint32_t>((sources_.size() + kPixelsPerPass - 1) / kPixelsPerPass);
}

void ScreenSum::begin_pass(uint32_t pass) {
  // Pass k sums pixels k, k + passes, k + 2 passes, … A step near the golden section that shares no
  // factor with the number of passes orders them so that early passes lie apart.
  auto step = static_cast<uint32_t>(0.618034 * passes_) | 1u;
  while (std::gcd(step, passes_) != 1) ++step;
  const auto first = static_cast<size_t>((uint64_t{pass} * step + seed_) % passes_);
  chosen_ = {};
  size_t k = 0;
  for (size_t i = first; i < sources_.size(); i += passes_, ++k) {
    const Source& s = sources_[i];
    chosen_.x[k] = s.position.x;
    chosen_.y[k] = s.position.y;
    chosen_.z[k] = s.position.z;
    chosen_.normal_x[k] = s.normal.x;
    chosen_.normal_y[k] = s.normal.y;
    chosen_.normal_z[k] = s.normal.z;
    chosen_.area_over_pi[k] = s.area_over_pi;
    chosen_.red[k] = s.radiance.r;
    chosen_.green[k] = s.radiance.g;
    chosen_.blue[k] = s.radiance.b;
  }
}

// Lanes of their own keep the order of additions the same however wide the machine adds.
template <class Factor>
glm::vec3 ScreenSum::sum(const Chosen& chosen, const FirstHit& receiver, Factor factor) {
  constexpr uint32_t kLanes = 16;
  const glm::vec3 position = receiver.surface.position, normal = receiver.surface.normal;
  float red[kLanes] = {}, green[kLanes] = {}, blue[kLanes] = {};
  for (uint32_t i = 0; i < kPixelsPerPass; i += kLanes) {
    for (uint32_t lane = 0; lane < kLanes; ++lane) {
      const uint32_t k = i + lane;
      const float f = factor(glm::vec3(chosen.x[k], chosen.y[k], chosen.z[k]) - position, normal,
                             glm::vec3(chosen.normal_x[k], chosen.normal_y[k], chosen.normal_z[k]),
                             chosen.area_over_pi[k]);
      red[lane] += f * chosen.red[k];
      green[lane] += f * chosen.green[k];
      blue[lane] += f * chosen.blue[k];
    }
  }
  glm::vec3 total(0.0f);
  for (uint32_t lane = 0; lane < kLanes; ++lane)
    total += glm::vec3(red[lane], green[lane], blue[lane]);
  return total;
}

glm::vec3 ScreenSum::at(const FirstHit& receiver, uint64_t&) const {
  const auto scale = static_cast<float>(passes_);
  if (form_factor_ == FormFactor::disc)
    return scale * sum(chosen_, receiver, [](auto... of) { return disc_form_factor(of...); });
  return scale * sum(chosen_, receiver, [](auto... of) { return point_form_factor(of...); });
}

}  // namespace lueur::reference
