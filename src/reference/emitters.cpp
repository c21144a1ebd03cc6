// SPDX-License-Identifier: MIT
#include "reference/emitters.h"

#include <algorithm>
#include <cmath>

#include "image/exposure.h"

namespace lueur::reference {

Emitters::Emitters(const World& world) : world_(&world) {
  const std::vector<Part>& parts = world.rays().parts();
  double total = 0.0;
  std::vector<double> cumulative;
  for (uint32_t p = 0; p < parts.size(); ++p) {
    const glm::vec3 emission = world.mean_emission(p);
    // A texture's mean may round to black although some texel glows; such a part is met by chance.
    const float radiance = luminance(emission.r, emission.g, emission.b);
    density_of_part_.push_back(radiance);
    if (!(radiance > 0.0f)) continue;
    for (uint32_t t = 0; t < parts[p].triangle_count; ++t) {
      const RayScene::Corners c = world.rays().corners(p, t);
      const float area = 0.5f * glm::length(glm::cross(c.b - c.a, c.c - c.a));
      if (!(area > 0.0f)) continue;
      total += static_cast<double>(area) * static_cast<double>(radiance);
      cumulative.push_back(total);
      entries_.push_back({p, t, 0.0f});
    }
  }
  for (size_t i = 0; i < entries_.size(); ++i)
    entries_[i].cumulative = static_cast<float>(cumulative[i] / total);
  for (float& density : density_of_part_)
    density = total > 0.0 ? static_cast<float>(static_cast<double>(density) / total) : 0.0f;
}

Emitters::Sample Emitters::sample(float choice, glm::vec2 u) const {
  const auto found =
      std::upper_bound(entries_.begin(), entries_.end(), choice,
                       [](float value, const Entry& entry) { return value < entry.cumulative; });
  const Entry& entry = found == entries_.end() ? entries_.back() : *found;
  const float root = std::sqrt(u.x);
  const float b = root * (1.0f - u.y), c = root * u.y;
  const RayScene::Corners corners = world_->rays().corners(entry.part, entry.triangle);
  const glm::vec3 normal = glm::normalize(glm::cross(corners.b - corners.a, corners.c - corners.a));
  return {(1.0f - b - c) * corners.a + b * corners.b + c * corners.c,
          world_->rays().parts()[entry.part].mirrored ? -normal : normal,
          world_->emission_at(entry.part, entry.triangle, b, c), density_of_part_[entry.part],
          entry.part};
}

}  // namespace lueur::reference
