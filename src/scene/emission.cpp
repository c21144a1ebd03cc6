// SPDX-License-Identifier: MIT
#include "scene/emission.h"

#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace lueur {
namespace {

double luminance(const glm::dvec3& color) {
  return glm::dot(color, glm::dvec3(0.2126, 0.7152, 0.0722));
}

double linear_of_srgb(double value) {
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

// The mean colour, linear.
glm::dvec3 mean_of(const Texture& texture) {
  std::array<double, 256> linear;
  for (size_t i = 0; i < linear.size(); ++i)
    linear[i] = linear_of_srgb(static_cast<double>(i) / 255.0);
  glm::dvec3 sum(0.0);
  for (size_t i = 0; i + 3 < texture.rgba.size(); i += 4)
    sum += glm::dvec3(linear[texture.rgba[i]], linear[texture.rgba[i + 1]],
                      linear[texture.rgba[i + 2]]);
  return texture.rgba.empty() ? sum : sum / static_cast<double>(texture.rgba.size() / 4);
}

// Mean luminance in cd/m2 by material.
std::vector<double> luminances(const Scene& scene) {
  std::vector<double> result;
  for (const Material& material : scene.materials) {
    glm::dvec3 emission(material.emission);
    const TextureUse& use = material.emission_texture;
    if (use.is_used() && luminance(emission) > 0.0)
      emission *= mean_of(scene.textures[static_cast<size_t>(use.texture)]);
    result.push_back(luminance(emission));
  }
  return result;
}

double area_of(const Mesh& mesh, const Primitive& primitive, const glm::mat4& world_from_object) {
  double area = 0.0;
  const auto corner = [&](uint32_t i) {
    const glm::vec3& position = mesh.vertices[mesh.indices[primitive.first_index + i]].position;
    return glm::dvec3(world_from_object * glm::vec4(position, 1.0f));
  };
  for (uint32_t i = 0; i + 2 < primitive.index_count; i += 3) {
    const glm::dvec3 a = corner(i);
    area += 0.5 * glm::length(glm::cross(corner(i + 1) - a, corner(i + 2) - a));
  }
  return area;
}

}  // namespace

double emitted_flux(const Scene& scene, const std::vector<glm::mat4>& world_from_node) {
  const std::vector<double> luminance_of = luminances(scene);
  double flux = 0.0;
  for (const MeshInstance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[static_cast<size_t>(instance.mesh)];
    for (const Primitive& primitive : mesh.primitives) {
      const double emitted = luminance_of[static_cast<size_t>(primitive.material)];
      if (emitted > 0.0)
        flux += glm::pi<double>() * emitted *
                area_of(mesh, primitive, world_from_node[static_cast<size_t>(instance.node)]);
    }
  }
  return flux;
}

}  // namespace lueur
