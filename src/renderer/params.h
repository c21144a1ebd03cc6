// SPDX-License-Identifier: MIT
// What the renderer's shaders get from the CPU.
#ifndef LUEUR_RENDERER_PARAMS_H
#define LUEUR_RENDERER_PARAMS_H

#include "shading/screen.h"

LUEUR_NAMESPACE_BEGIN

// One drawn instance of a mesh.
struct InstanceData {
  mat4 world_from_object;
  mat4 world_from_object_before;  // in the previous frame
  mat3 world_from_object_normal;  // inverse transpose
  // Where the instance's skin or morph targets have moved its vertices: what to add to a vertex'
  // index to find it among the DeformedVertex.
  uint is_deformed;
  int first_deformed;
  uint surface_bits;  // kKeepsLight, or 0
  uint object;        // 1 + the index of the moving object that it belongs to; 0: it stands still
};

// The alpha of `material` in 255ths: what a surface is besides its numbers.
const uint kKeepsLight = 128u;  // it passes none on: MeshInstance::passes_light_on

LUEUR_SHARED uint surface_bits(vec4 material) {
  return uint(material.a * 255.0f + 0.5f);
}

LUEUR_SHARED bool keeps_light(vec4 material) {
  return (surface_bits(material) & kKeepsLight) != 0u;
}

// It reflects by a cosine lobe instead of GGX. The lobe's index in the scene's table is the other
// bits of the alpha, then the 8 bits of blue.
const uint kHasCosineLobe = 64u;
const uint kMostCosineLobes = 16384u;

LUEUR_SHARED bool has_cosine_lobe(vec4 material) {
  return (surface_bits(material) & kHasCosineLobe) != 0u;
}

LUEUR_SHARED uint cosine_lobe_index(vec4 material) {
  return (surface_bits(material) & 63u) * 256u + uint(material.b * 255.0f + 0.5f);
}

// A cosine lobe of the scene's table, with its colour: see CosineLobe in lueur/g_buffer.h.
struct LobeData {
  vec3 color;
  float exponent;
  float c_xy;
  float c_z;
  float name;  // the alpha of GBuffer::reflectance by which techniques know it
};

struct DeformedVertex {
  vec3 position;  // object space, or world space where the instance is skinned
  vec3 position_before;
  vec3 normal;
  vec3 tangent;
};

// Where on its texture a surface's coordinates lead.
struct TexturePlacement {
  vec2 along_u;
  vec2 along_v;
  vec2 offset;
  uint uv_set;
};

struct MaterialData {
  vec4 base_color;
  vec3 emission;
  float metallic;
  float roughness;
  float specular;  // share of a dielectric's 0.04
  float normal_scale;
  float alpha_cutoff;  // 0: opaque
  uint has_normal_map;
  uint unlit;
  uint cosine_lobe;  // 0: GGX; else 1 + the index among LobeData
  TexturePlacement base_color_place;
  TexturePlacement metallic_roughness_place;
  TexturePlacement normal_place;
  TexturePlacement emission_place;
};

struct GBufferParams {
  mat4 clip_from_world;
  mat4 clip_from_world_before;
};

struct ShadowParams {
  mat4 clip_from_world;
};

struct DrawParams {
  uint material;
};

const uint kLightPoint = 0u;
const uint kLightSpot = 1u;
const uint kLightDirectional = 2u;

struct LightParams {
  Screen screen;
  mat4 world_from_view;
  mat4 shadow_from_world;  // clip space of the shadow map (spot, directional)
  vec3 position_world;
  vec3 direction_world;  // in which the light shines (spot, directional)
  vec3 intensity;        // cd or lux, times colour
  ivec2 extent;
  uint kind;
  float cone_scale;  // of cone_attenuation()
  float cone_offset;
  float inverse_range;  // of range_window()
  float shadow_near_m;  // near plane of the point light's faces
  // Side of a shadow texel at distance 1 from the light; of a directional light, everywhere.
  // Metres.
  float texel_m;
};

struct SurfaceParams {
  ivec2 extent;
  uint has_emission;
};

struct ReflectanceParams {
  ivec2 extent;
};

struct ObjectParams {
  ivec2 extent;
};

struct PassedOnParams {
  ivec2 extent;
};

struct ComposeParams {
  ivec2 extent;
  uint has_indirect;
  uint has_indirect_specular;
};

struct ComposeOccludedParams {
  ivec2 extent;
};

// The direction of a pixel in the environment's picture is corner + x step_x + y step_y.
struct BackgroundParams {
  ivec2 extent;
  uint everywhere;  // also where there is a surface; then `depth` is not read
  vec3 corner;
  vec3 step_x;
  vec3 step_y;
  float level;  // of the picture's smaller versions
  float intensity;
};

LUEUR_NAMESPACE_END

#endif
