// SPDX-License-Identifier: MIT
#include "renderer/lobe_table.h"

#include <array>
#include <cmath>
#include <map>

namespace lueur {
namespace {

// GBuffer::reflectance can name no more.
constexpr size_t kMostShapes = 2047;

// The perceptual roughness of a GGX lobe as wide: alpha^2 = 2 / (exponent + 2).
float roughness_of(float exponent) {
  return std::pow(2.0f / (exponent + 2.0f), 0.25f);
}

}  // namespace

LobeTable lobe_table(std::span<const Material> materials) {
  LobeTable table;
  std::map<std::array<float, 3>, float> name_of_shape;
  std::map<std::array<float, 6>, uint32_t> place_of_lobe;
  const auto name = [&](const PhongLobe& lobe) {
    const auto [entry, is_new] = name_of_shape.try_emplace({lobe.exponent, lobe.c_xy, lobe.c_z});
    if (!is_new) return entry->second;
    if (table.shapes.size() == kMostShapes) return entry->second = roughness_of(lobe.exponent);
    table.shapes.push_back({lobe.exponent, lobe.c_xy, lobe.c_z});
    return entry->second = -static_cast<float>(table.shapes.size());
  };
  for (const Material& material : materials) {
    uint32_t& place = table.of_material.emplace_back(0);
    if (!material.phong || material.unlit) continue;
    const PhongLobe& lobe = *material.phong;
    const glm::vec3& color = lobe.color;
    uint32_t& known =
        place_of_lobe[{color.r, color.g, color.b, lobe.exponent, lobe.c_xy, lobe.c_z}];
    if (known == 0 && table.lobes.size() < kMostCosineLobes) {
      table.lobes.push_back({color, lobe.exponent, lobe.c_xy, lobe.c_z, name(lobe)});
      known = static_cast<uint32_t>(table.lobes.size());
    }
    place = known;
    if (place == 0) ++table.left_out;
  }
  return table;
}

}  // namespace lueur
