// SPDX-License-Identifier: MIT
// Rules of glTF 2.0 that no table can state: how objects fit together, and what their bytes hold.
// All of them bear JSON of any shape; the schema tells of wrong types.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scene/conformance/accessor_table.h"
#include "scene/conformance/findings.h"
#include "scene/conformance/json_read.h"
#include "scene/gltf_file.h"

namespace lueur::conformance {

// What a buffer view is read as.
enum class ViewUse : uint8_t { none, vertices, indices, image, other };

struct Asset {
  const GltfFile& file;
  const Json& root;
  AccessorTable& accessors;
  Findings& findings;
  std::vector<ViewUse> view_uses;  // of each buffer view; from its target, then from its users
  std::set<std::string_view> extensions;  // extensionsUsed

  const Json& list_of(std::string_view name) const { return list(root, name); }
  bool uses_extension(std::string_view name) const { return extensions.contains(name); }
  void add(const std::string& path, std::string_view what) { findings.add(path, what); }

  // Notes that `path` reads a view as `use`; tells of it where that contradicts an earlier use.
  void use_view(size_t view, ViewUse use, const std::string& path);
  // The same for the view of an accessor, which must have no stride except for vertices.
  void use_accessor(size_t accessor, ViewUse use, const std::string& path);
};

void check_extension_lists(Asset& asset);
void check_buffers(Asset& asset);     // buffers and views
void check_accessors(Asset& asset);   // layout, bounds against data, sparse parts
void check_meshes(Asset& asset);      // attributes, indices, morph targets, materials' needs
void check_vertices(Asset& asset);    // unit vectors, colours, joints and weights
void check_nodes(Asset& asset);       // transforms, trees, scenes
void check_skins(Asset& asset);       // joints, matrices, scenes
void check_animations(Asset& asset);  // channels, samplers, times, rotations
void check_images(Asset& asset);      // types, headers, textures
void check_cameras_and_lights(Asset& asset);
void check_materials(Asset& asset);  // what depends on two properties

}  // namespace lueur::conformance
