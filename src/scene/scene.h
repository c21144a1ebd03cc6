// SPDX-License-Identifier: MIT
// A scene as plain CPU data, whatever it came from. Right-handed, y up, metres; matrices are
// column-major and map column vectors, as in glTF 2.0. Angles in radians.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_precision.hpp>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "scene/environment.h"

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

// A texture as a material uses it. A bare index means: read where the first coordinates say.
struct TextureUse {
  TextureUse(int32_t texture_index = kNone) : texture(texture_index) {}

  int32_t texture;      // in Scene::textures
  uint32_t uv_set = 0;  // 0: Vertex::uv, 1: Vertex::uv_2
  // Applied to the coordinates (u, v, 1): the columns are where u and v lead, and the offset.
  glm::mat3x2 transform{1.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f};

  bool operator==(const TextureUse&) const = default;
  bool is_used() const { return texture != kNone; }
};

// Where on the texture a point with these coordinates lies.
inline glm::vec2 texture_place(const TextureUse& use, const glm::vec2& uv, const glm::vec2& uv_2) {
  return use.transform * glm::vec3(use.uv_set == 0 ? uv : uv_2, 1.0f);
}

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
  // Linear Rec.709 albedo and alpha; multiplies the texture and the vertices' colour.
  glm::vec4 base_color{1.0f};
  float metallic = 1.0f;     // multiplies the texture's blue channel
  float roughness = 1.0f;    // perceptual; alpha = roughness²; multiplies green
  float specular = 1.0f;     // share of a dielectric's 0.04: 0 is purely diffuse
  glm::vec3 emission{0.0f};  // radiance in cd/m², emissive strength included
  float normal_scale = 1.0f;
  TextureUse base_color_texture;          // sRGB
  TextureUse metallic_roughness_texture;  // linear
  TextureUse normal_texture;              // linear, tangent space, +y up; by Vertex::uv
  TextureUse emission_texture;            // sRGB
  std::optional<PhongLobe> phong;         // takes the place of the specular GGX lobe
  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;
  bool double_sided = false;
  // Looks like its base colour whatever the light, as if it emitted that radiance and reflected
  // nothing.
  bool unlit = false;
};

inline constexpr uint16_t kFullColor = 65535;  // 1 in Vertex::color

struct Vertex {
  glm::vec3 position;              // object space
  glm::vec3 normal;                // unit length
  glm::vec4 tangent;               // unit length; w = ±1, bitangent = cross(normal, tangent) * w
  glm::vec2 uv;                    // origin at the top left of the texture
  glm::vec2 uv_2{0.0f};            // a second set, for textures that say so
  glm::u16vec4 color{kFullColor};  // linear RGBA in 65535ths
};

inline glm::vec4 color_of(const Vertex& vertex) {
  return glm::vec4(vertex.color) / float{kFullColor};
}

// A range of a mesh's indices drawn with one material. Front faces are counter-clockwise.
struct Primitive {
  uint32_t first_index = 0;
  uint32_t index_count = 0;  // a multiple of 3
  int32_t material = 0;      // always valid
};

// The joints of a skin that move a vertex.
struct JointInfluence {
  glm::u16vec4 joints{uint16_t{0}};  // in Skin::joints
  glm::vec4 weights{0.0f};           // 0 or more, their sum is 1
};

// What a morph target adds to each vertex, times its weight. Empty: nothing.
struct MorphTarget {
  std::vector<glm::vec3> positions, normals, tangents;
};

struct Mesh {
  std::string name;
  std::vector<Vertex> vertices;
  std::vector<uint32_t> indices;  // into `vertices`
  std::vector<Primitive> primitives;
  std::vector<JointInfluence> influences;  // one a vertex, or none: the mesh cannot be skinned
  std::vector<MorphTarget> morph_targets;
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

// Nodes that a mesh follows instead of its own one.
struct Skin {
  std::string name;
  std::vector<int32_t> joints;             // nodes
  std::vector<glm::mat4> joint_from_mesh;  // one a joint: inverse bind matrices
};

struct MeshInstance {
  int32_t node = 0;
  int32_t mesh = 0;
  int32_t skin = kNone;              // only for meshes with influences; then `node` moves nothing
  std::vector<float> morph_weights;  // at rest, one for each target of the mesh
  // false: it is lit and gets indirect light, and techniques get none from it, as artists want it
  // of characters that must not stain their surroundings (HSSIL 4). The reference ignores it.
  bool passes_light_on = true;
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
  // Where the light of a point or spot ends; infinity: nowhere, as in nature.
  float range_m = std::numeric_limits<float>::infinity();
};

enum class AnimationPath : uint8_t { translation, rotation, scale, morph_weight };
// Linear means slerp for rotations. Cubic splines are glTF's: Hermite, with a tangent on each side
// of a key in units per second.
enum class Interpolation : uint8_t { linear, step, cubic_spline };

// Key frames of one node's property. A value is xyz, a quaternion as xyzw, or a weight in x; a
// cubic spline has three a key: the tangent before, the value, the tangent after.
struct AnimationChannel {
  int32_t node = 0;
  AnimationPath path = AnimationPath::translation;
  uint32_t morph_target = 0;  // of the meshes on the node
  Interpolation interpolation = Interpolation::linear;
  std::vector<float> times_s;  // strictly ascending
  std::vector<glm::vec4> values;
};

struct Scene {
  std::string name;
  std::vector<Texture> textures;
  std::vector<Material> materials;  // at least one
  std::vector<Mesh> meshes;
  std::vector<Node> nodes;
  std::vector<Skin> skins;
  std::vector<MeshInstance> instances;
  std::vector<Camera> cameras;  // at least one after loading
  std::vector<Light> lights;    // may be none where surfaces or the environment shine: framing.h
  std::optional<Environment> environment;  // what is seen, and shines, where no surface is
  std::vector<AnimationChannel> animation;
  std::optional<float> exposure_ev;   // stops the scene's author wants; none: the program decides
  std::vector<std::string> warnings;  // one line each: what the file had that was left out or added
};

// The rigid transform of a camera on a node: where it stands and how it is turned. Scale is left
// out, as a camera does not scale.
glm::mat4 world_from_camera(const glm::mat4& world_from_node);

bool is_finite(const glm::mat4& m);

// World matrices of all nodes at `time_s`; animation loops over its longest channel, and where it
// leaves the range of floats, all nodes are at rest. How skins and morph targets shape meshes at
// that time is in scene/deform.h.
std::vector<glm::mat4> pose(const Scene& scene, float time_s);

// The morph weights of each instance at `time_s`, one for each target of its mesh. Of all at once,
// as files may have many channels beside many instances.
std::vector<std::vector<float>> morph_weights(const Scene& scene, float time_s);

// A box in world space.
struct Bounds {
  glm::vec3 min{0.0f};
  glm::vec3 max{0.0f};
};

// Triangles drawn, instances counted each time.
uint64_t triangle_count(const Scene& scene);

}  // namespace lueur
