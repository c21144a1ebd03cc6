// SPDX-License-Identifier: MIT
// The geometry of an OBJ file: first as it stands there, then as meshes.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lueur/result.h"
#include "scene/load_limits.h"
#include "scene/obj_text.h"
#include "scene/scene.h"
#include "scene/warnings.h"

namespace lueur {

// Indices into ObjGeometry's arrays, checked; kNone for what the corner lacks.
struct ObjCorner {
  int32_t position = kNone;
  int32_t uv = kNone;
  int32_t normal = kNone;
};

struct ObjFace {
  uint32_t first_corner = 0;
  uint32_t corner_count = 0;
  uint32_t mesh = 0;       // index into mesh_names
  uint32_t material = 0;   // index into material_names
  uint32_t smoothing = 0;  // 0: flat
};

struct ObjGeometry {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec2> uvs;  // as in the file: v points up
  std::vector<glm::vec3> normals;
  std::vector<ObjCorner> corners;
  std::vector<ObjFace> faces;
  std::vector<std::string> mesh_names;
  std::vector<std::string> material_names;  // as used; "" for faces before any usemtl
  std::vector<std::string> libraries;       // what mtllib names, each once
};

// Fails on malformed numbers, indices that point at nothing, and what goes beyond the limits.
Result<ObjGeometry> read_obj_geometry(std::string_view text, const std::string& file,
                                      const LoadLimits& limits, Warnings& warnings);

// uv' = uv * scale + offset, with v pointing up.
struct UvTransform {
  glm::vec2 scale{1.0f};
  glm::vec2 offset{0.0f};
  bool operator==(const UvTransform&) const = default;
};

// One mesh for each name that has triangles, vertices shared where all their parts are the same.
// `materials` tells for each name in material_names where it lies in Scene::materials and how its
// textures lie. Takes the geometry apart. Fails when there are more vertices or indices than
// `limits` allow; `file` is for messages.
struct ObjMaterialUse {
  int32_t material = 0;
  UvTransform uv;
};
Result<std::vector<Mesh>> make_obj_meshes(ObjGeometry geometry,
                                          const std::vector<ObjMaterialUse>& materials,
                                          const std::string& file, const LoadLimits& limits,
                                          Warnings& warnings);

}  // namespace lueur
