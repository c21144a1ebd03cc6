// SPDX-License-Identifier: MIT
// The vertices of one glTF primitive: its attributes and morph targets, checked and put together.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "lueur/result.h"
#include "scene/gltf_file.h"
#include "scene/scene.h"

namespace lueur {

// The accessors that a primitive's vertices are read from; kNone where it has none. Primitives with
// equal ones share their vertices.
struct VertexAccessors {
  int32_t position = kNone, normal = kNone, tangent = kNone;
  std::array<int32_t, 2> uv{kNone, kNone};  // of TEXCOORD_n, n as in uv_sets
  std::array<uint32_t, 2> uv_sets{};
  int32_t color = kNone;
  int32_t joints = kNone, weights = kNone;
  struct Target {
    int32_t position = kNone, normal = kNone, tangent = kNone;
    auto operator<=>(const Target&) const = default;
  };
  std::vector<Target> targets;
  auto operator<=>(const VertexAccessors&) const = default;
};

struct PrimitiveVertices {
  std::vector<Vertex> vertices;            // normals 0 and tangents' w 0 where the file has none
  std::vector<JointInfluence> influences;  // empty, or as many
  std::vector<MorphTarget> targets;
};

// `uv_sets` says which TEXCOORD_n become Vertex::uv and Vertex::uv_2. Warns of attributes that are
// left out.
Result<VertexAccessors> find_vertices(const GltfFile& file, const JsonCursor& primitive,
                                      const std::array<std::optional<uint32_t>, 2>& uv_sets,
                                      Warnings& warnings);

// Reads `count` vertices. Refuses values that are not finite and accessors that do not fit; `at` is
// the primitive and `mesh_name` what to call its mesh.
Result<PrimitiveVertices> read_vertices(const GltfFile& file, const JsonCursor& at,
                                        const VertexAccessors& accessors, uint64_t count,
                                        const std::string& mesh_name, Warnings& warnings);

// Gives each corner a vertex of its own, in the corners' order, with its face's normal; afterwards
// `corners` counts up from 0.
void split_flat(PrimitiveVertices& primitive, std::vector<uint32_t>& corners);

}  // namespace lueur
