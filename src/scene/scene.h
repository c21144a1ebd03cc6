// SPDX-License-Identifier: MIT
// A scene as plain CPU data, whatever it came from. Right-handed, y up, metres; matrices are
// column-major and map column vectors, as in glTF 2.0. Angles in radians.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <string>
#include <vector>

namespace lueur {

inline constexpr int32_t kNone = -1;  // an index that points at nothing

enum class Wrap : uint8_t { repeat, clamp_to_edge, mirrored_repeat };

// 8-bit RGBA as stored in the file. Whether the values are sRGB-encoded follows from the use: base
// colour and emission are, metallic-roughness and normal maps are not.
struct Texture {
  std::string name;
  uint32_t width = 0;
  uint32_t height = 0;
  std::vector<uint8_t> rgba;  // width * height * 4, rows from the top
  Wrap wrap_u = Wrap::repeat;
  Wrap wrap_v = Wrap::repeat;
  bool nearest = false;  // magnify without interpolation
};

enum class AlphaMode : uint8_t { opaque, mask };

// A cosine lobe, normalised so that `color` is what it reflects of light along its own axis. The
// light's direction is mirrored by the coefficients in the surface's frame (z is the normal):
//   f = color (n + 2) / (2 pi m^n) max(c_xy (l_x v_x + l_y v_y) + c_z l_z v_z, 0)^n,
//   m = max(|c_xy|, |c_z|).
// Coefficients -1 and 1 are Phong's lobe, others the isotropic ones of Lafortune et al. 1997.
struct PhongLobe {
  glm::vec3 color{0.0f};
  float exponent = 1.0f;  // n
  float c_xy = -1.0f;
  float c_z = 1.0f;
};

// glTF's metallic-roughness model.
struct Material {
  std::string name;
  glm::vec4 base_color{1.0f};  // linear Rec.709 albedo and alpha, multiplies the texture
  float metallic = 1.0f;       // multiplies the texture's blue channel
  float roughness = 1.0f;      // perceptual; alpha = roughness²; multiplies green
  float specular = 1.0f;       // share of a dielectric's 0.04: 0 is purely diffuse
  glm::vec3 emission{0.0f};    // radiance in cd/m², emissive strength included
  float normal_scale = 1.0f;
  int32_t base_color_texture = kNone;          // sRGB
  int32_t metallic_roughness_texture = kNone;  // linear
  int32_t normal_texture = kNone;              // linear, tangent space, +y up
  int32_t emission_texture = kNone;            // sRGB
  std::optional<PhongLobe> phong;              // takes the place of the specular GGX lobe
  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;
  bool double_sided = false;
};

struct Vertex {
  glm::vec3 position;  // object space
  glm::vec3 normal;    // unit length
  glm::vec4 tangent;   // unit length; w = ±1, bitangent = cross(normal, tangent) * w
  glm::vec2 uv;        // origin at the top left of the texture
};

// A range of a mesh's indices drawn with one material. Front faces are counter-clockwise.
struct Primitive {
  uint32_t first_index = 0;
  uint32_t index_count = 0;  // a multiple of 3
  int32_t material = 0;      // always valid
};

struct Mesh {
  std::string name;
  std::vector<Vertex> vertices;
  std::vector<uint32_t> indices;  // into `vertices`
  std::vector<Primitive> primitives;
};

// Local transform = translation * rotation * scale.
struct Node {
  std::string name;
  int32_t parent = kNone;  // always smaller than the node's own index: one pass poses the scene
  glm::vec3 translation{0.0f};
  glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
  glm::vec3 scale{1.0f};
  // Takes the place of the three above where a file gives a matrix that has shear in it.
  std::optional<glm::mat4> matrix;
};

struct MeshInstance {
  int32_t node = 0;
  int32_t mesh = 0;
};

// Looks down its node's -z with +y up.
struct Camera {
  std::string name;
  int32_t node = 0;
  float vertical_fov_rad = 0.9f;
  float near_m = 0.05f;  // the far plane is at infinity
};

enum class LightKind : uint8_t { point, spot, directional };

// KHR_lights_punctual: shines along its node's -z.
struct Light {
  std::string name;
  LightKind kind = LightKind::point;
  int32_t node = 0;
  glm::vec3 color{1.0f};        // linear Rec.709, multiplies the intensity
  float intensity = 1.0f;       // cd for point and spot, lux for directional
  float inner_cone_rad = 0.0f;  // half angles, spot only
  float outer_cone_rad = 0.7854f;
};

enum class AnimationPath : uint8_t { translation, rotation, scale };

// Key frames of one node's property; `values` holds xyz, or a quaternion as xyzw.
struct AnimationChannel {
  int32_t node = 0;
  AnimationPath path = AnimationPath::translation;
  bool step = false;           // otherwise linear (slerp for rotations)
  std::vector<float> times_s;  // strictly ascending
  std::vector<glm::vec4> values;
};

struct Scene {
  std::string name;
  std::vector<Texture> textures;
  std::vector<Material> materials;  // at least one
  std::vector<Mesh> meshes;
  std::vector<Node> nodes;
  std::vector<MeshInstance> instances;
  std::vector<Camera> cameras;  // at least one after loading
  std::vector<Light> lights;    // at least one after complete(); see framing.h
  std::vector<AnimationChannel> animation;
  std::optional<float> exposure_ev;   // stops the scene's author wants; none: the program decides
  std::vector<std::string> warnings;  // one line each: what the file had that was left out or added
};

// The rigid transform of a camera on a node: where it stands and how it is turned. Scale is left
// out, as a camera does not scale.
glm::mat4 world_from_camera(const glm::mat4& world_from_node);

// World matrices of all nodes at `time_s`; animation loops over its longest channel.
std::vector<glm::mat4> pose(const Scene& scene, float time_s);

// Box around everything drawn, in world space at `time_s`. Empty scenes give min = max = 0.
struct Bounds {
  glm::vec3 min{0.0f};
  glm::vec3 max{0.0f};
};
Bounds bounds(const Scene& scene, const std::vector<glm::mat4>& world_from_node);

// Triangles drawn, instances counted each time.
uint64_t triangle_count(const Scene& scene);

}  // namespace lueur
