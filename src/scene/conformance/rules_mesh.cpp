// SPDX-License-Identifier: MIT
// Meshes as their accessors are declared; rules_vertex.cpp looks into the vertices.
#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "scene/conformance/rules.h"

namespace lueur::conformance {
namespace {

// What an attribute's accessor may be; `kinds` has a letter for each: f float, B and H normalized 8
// and 16-bit integers without a sign, b and h such integers as they are.
struct AttributeRow {
  std::string_view name;  // without its number
  bool numbered;
  std::string_view types;
  std::string_view kinds;
};
constexpr std::array kAttributes{
    AttributeRow{"POSITION", false, "VEC3", "f"},    AttributeRow{"NORMAL", false, "VEC3", "f"},
    AttributeRow{"TANGENT", false, "VEC4", "f"},     AttributeRow{"TEXCOORD", true, "VEC2", "fBH"},
    AttributeRow{"COLOR", true, "VEC3 VEC4", "fBH"}, AttributeRow{"JOINTS", true, "VEC4", "bh"},
    AttributeRow{"WEIGHTS", true, "VEC4", "fBH"}};

// KHR_mesh_quantization adds integers of any sign to these.
bool may_be_quantized(std::string_view name) {
  return name == "POSITION" || name == "NORMAL" || name == "TANGENT" || name == "TEXCOORD";
}

// The row of "TEXCOORD_1"; null for names that glTF does not have.
const AttributeRow* row_of(std::string_view attribute) {
  for (const AttributeRow& row : kAttributes) {
    if (!row.numbered && attribute == row.name) return &row;
    if (!row.numbered || !attribute.starts_with(row.name)) continue;
    const std::string_view number = attribute.substr(row.name.size());
    const bool digits = number.size() >= 2 && number[0] == '_' &&
                        number.find_first_not_of("0123456789", 1) == std::string_view::npos;
    // "00" and "01" are not numbers as glTF writes them.
    if (digits && (number[1] != '0' || number.size() == 2)) return &row;
  }
  return nullptr;
}

char kind_of(const Accessor& accessor) {
  switch (accessor.component) {
    case kFloat32:
      return 'f';
    case kUint8:
      return accessor.normalized ? 'B' : 'b';
    case kUint16:
      return accessor.normalized ? 'H' : 'h';
    default:
      return '?';
  }
}

// An attribute that a material addresses textures with, and the first texture that it is for.
struct UvUse {
  std::string attribute;
  std::string path;
};

std::vector<UvUse> uv_uses(const Json& material, const std::string& material_path) {
  constexpr size_t kMaxUses = 8;  // each is looked for in each primitive
  std::vector<UvUse> uses;
  std::vector<std::pair<const Json*, std::string>> open{{&material, material_path}};
  while (!open.empty()) {
    const auto [object, path] = std::move(open.back());
    open.pop_back();
    for (const auto& [key, value] : object->items()) {
      if (!value.is_object() || key == "extras") continue;
      open.emplace_back(&value, path_to(path, printable(key)));
      if (!key.ends_with("Texture") || !has(value, "index")) continue;
      const Json& transformed = member(value, {"extensions", "KHR_texture_transform", "texCoord"});
      const uint64_t set =
          whole_number(transformed).value_or(whole_number(value, "texCoord").value_or(0));
      const std::string attribute = "TEXCOORD_" + std::to_string(set);
      const bool is_known = std::ranges::find(uses, attribute, &UvUse::attribute) != uses.end();
      if (!is_known && uses.size() < kMaxUses) uses.push_back({attribute, open.back().second});
    }
  }
  return uses;
}

// What all primitives of a file share.
struct MeshContext {
  std::vector<std::vector<UvUse>> uses_of_material;
  std::map<size_t, std::map<size_t, std::string>> accessors_of_view;  // those of vertices
};

class PrimitiveCheck {
 public:
  PrimitiveCheck(Asset& asset, MeshContext& context, const Json& primitive, std::string path)
      : asset_(&asset), context_(&context), primitive_(&primitive), path_(std::move(path)) {}

  void check();

 private:
  void check_attribute(const std::string& name, size_t accessor, const std::string& path,
                       bool is_morph);
  void check_counts_of_names();
  void check_indices();
  void check_targets();
  void check_material();

  Asset* asset_;
  MeshContext* context_;
  const Json* primitive_;
  std::string path_;
};

void PrimitiveCheck::check_attribute(const std::string& name, size_t index, const std::string& path,
                                     bool is_morph) {
  const Accessor& accessor = asset_->accessors[index];
  if (!accessor.known()) return;
  asset_->use_accessor(index, ViewUse::vertices, path);
  if (accessor.component == kUint32) asset_->add(path, "attributes cannot be 32-bit integers");
  if (name == "POSITION" && !accessor.has_bounds)
    asset_->add(path, "the accessor of positions needs min and max");
  if (accessor.view) {
    const Json& view = asset_->list_of("bufferViews")[*accessor.view];
    const bool has_stride = has(view, "byteStride");
    context_->accessors_of_view[*accessor.view].emplace(index, path);
    if (accessor.offset % 4 != 0 || (!has_stride && accessor.element_bytes % 4 != 0))
      asset_->add(path, "vertices do not start at multiples of 4 bytes");
  }
  const AttributeRow* row = row_of(name);
  if (!row) return;
  const bool quantized =
      may_be_quantized(row->name) && asset_->uses_extension("KHR_mesh_quantization");
  // A morph target's tangent has no sign, and its numbers may have one.
  const std::string_view types = is_morph && name == "TANGENT" ? "VEC3" : row->types;
  const bool kind_fits = quantized || row->kinds.find(kind_of(accessor)) != std::string_view::npos;
  if (types.find(accessor.type) == std::string_view::npos || (!kind_fits && !is_morph))
    asset_->add(path, "an accessor of type " + std::string(accessor.type) + " and component type " +
                          std::to_string(accessor.component) +
                          (accessor.normalized ? ", normalized," : "") + " cannot be " + name);
}

void PrimitiveCheck::check() {
  const Json& attributes = member(*primitive_, "attributes");
  const std::string at = path_to(path_, "attributes");
  if (!attributes.is_object()) return;
  if (attributes.empty()) asset_->add(at, "must not be empty");
  const size_t accessor_count = asset_->accessors.size();
  const auto positions = index_below(attributes, "POSITION", accessor_count);
  for (const auto& [name, value] : attributes.items()) {
    const std::string path = path_to(at, printable(name));
    if (!name.starts_with('_') && !row_of(name)) asset_->add(path, "is not an attribute of glTF");
    const auto index = index_below(attributes, name, accessor_count);
    if (!index) {
      asset_->add(path, "is not below the " + std::to_string(accessor_count) + " accessors");
      continue;
    }
    check_attribute(name, *index, path, false);
    const Accessor& accessor = asset_->accessors[*index];
    if (positions && accessor.known() && accessor.count != asset_->accessors[*positions].count)
      asset_->add(path, "has " + std::to_string(accessor.count) + " elements, POSITION has " +
                            std::to_string(asset_->accessors[*positions].count));
  }
  check_counts_of_names();
  check_indices();
  check_targets();
  check_material();
}

// Numbered attributes count from 0, and joints come with weights.
void PrimitiveCheck::check_counts_of_names() {
  const Json& attributes = member(*primitive_, "attributes");
  const std::string at = path_to(path_, "attributes");
  std::map<std::string_view, size_t> counts;
  for (const AttributeRow& row : kAttributes) {
    if (!row.numbered) continue;
    size_t& count = counts[row.name];
    size_t in_order = 0;
    for (const auto& [name, value] : attributes.items()) count += row_of(name) == &row;
    while (has(attributes, std::string(row.name) + "_" + std::to_string(in_order))) ++in_order;
    if (count != in_order)
      asset_->add(at, std::string(row.name) + " is not numbered from 0 without gaps");
  }
  if (counts["JOINTS"] != counts["WEIGHTS"])
    asset_->add(at, "has " + std::to_string(counts["JOINTS"]) + " sets of joints, but " +
                        std::to_string(counts["WEIGHTS"]) + " sets of weights");
}

void PrimitiveCheck::check_indices() {
  const auto index = index_below(*primitive_, "indices", asset_->accessors.size());
  if (!index) return;
  const std::string path = path_to(path_, "indices");
  const Accessor& accessor = asset_->accessors[*index];
  if (!accessor.known()) return;
  asset_->use_accessor(*index, ViewUse::indices, path);
  const bool is_index = accessor.component == kUint8 || accessor.component == kUint16 ||
                        accessor.component == kUint32;
  if (accessor.type != "SCALAR" || !is_index || accessor.normalized)
    return asset_->add(path, "indices have to be SCALAR and unsigned integers");

  const auto& range = asset_->accessors.range(*index);
  if (!range) return;
  constexpr std::array<double, 3> kRestart{0xff, 0xffff, 4294967295.0};
  const double restart = kRestart[accessor.component == kUint8    ? 0
                                  : accessor.component == kUint16 ? 1
                                                                  : 2];
  const auto positions =
      index_below(member(*primitive_, "attributes"), "POSITION", asset_->accessors.size());
  const uint64_t vertices = positions ? asset_->accessors[*positions].count : 0;
  const std::string largest = Json(range->max[0]).dump();
  if (range->max[0] == restart)
    asset_->add(path, largest + " is no index: it is kept for restarting primitives");
  else if (vertices > 0 && range->max[0] >= static_cast<double>(vertices))
    asset_->add(path, largest + " is not below the " + std::to_string(vertices) + " vertices");
}

void PrimitiveCheck::check_targets() {
  const Json& targets = list(*primitive_, "targets");
  const Json& attributes = member(*primitive_, "attributes");
  const size_t accessor_count = asset_->accessors.size();
  for (size_t i = 0; i < targets.size(); ++i) {
    const std::string at = path_to(path_, "targets", i);
    if (!targets[i].is_object()) continue;
    if (targets[i].empty()) asset_->add(at, "must not be empty");
    for (const auto& [name, value] : targets[i].items()) {
      const std::string path = path_to(at, printable(name));
      if (!name.starts_with('_') && !row_of(name)) asset_->add(path, "is not an attribute of glTF");
      if (!has(attributes, name)) asset_->add(path, "the primitive has no such attribute");
      const auto index = index_below(targets[i], name, accessor_count);
      if (!index) {
        asset_->add(path, "is not below the " + std::to_string(accessor_count) + " accessors");
        continue;
      }
      check_attribute(name, *index, path, true);
      const Accessor& accessor = asset_->accessors[*index];
      const auto base = index_below(attributes, name, accessor_count);
      if (base && accessor.known() && accessor.count != asset_->accessors[*base].count)
        asset_->add(path, "has " + std::to_string(accessor.count) +
                              " elements, the attribute itself has " +
                              std::to_string(asset_->accessors[*base].count));
    }
  }
}

void PrimitiveCheck::check_material() {
  const Json& materials = asset_->list_of("materials");
  const auto index = index_below(*primitive_, "material", materials.size());
  if (!index) return;
  const Json& material = materials[*index];
  for (const UvUse& use : context_->uses_of_material[*index])
    if (!has(member(*primitive_, "attributes"), use.attribute))
      asset_->add(path_to(path_, "material"),
                  use.path + " needs " + use.attribute + ", which the primitive does not have");
  const Json& extensions = member(material, "extensions");
  const bool needs_tangents =
      has(member(extensions, "KHR_materials_anisotropy"), "anisotropyTexture") ||
      has(member(extensions, "KHR_materials_clearcoat"), "clearcoatNormalTexture");
  const Json& attributes = member(*primitive_, "attributes");
  if (needs_tangents && !has(attributes, "TANGENT") && !has(material, "normalTexture"))
    asset_->add(path_to(path_, "material"),
                path_to("materials", *index) +
                    " needs tangents, and there is no TANGENT and no normalTexture");
}

// What the variants of a primitive map to; a variant is mapped once.
void check_variants(Asset& asset, const Json& primitive, const std::string& path) {
  const Json& mappings =
      list(member(primitive, {"extensions", "KHR_materials_variants"}), "mappings");
  const std::string at = path + ".extensions.KHR_materials_variants";
  std::set<uint64_t> mapped;
  for (size_t i = 0; i < mappings.size(); ++i) {
    const Json& variants = list(mappings[i], "variants");
    for (size_t k = 0; k < variants.size(); ++k) {
      const auto variant = whole_number(variants[k]);
      if (variant && !mapped.insert(*variant).second)
        asset.add(path_to(path_to(at, "mappings", i), "variants", k),
                  "this variant is mapped before");
    }
  }
}

}  // namespace

void check_meshes(Asset& asset) {
  const Json& meshes = asset.list_of("meshes");
  const Json& materials = asset.list_of("materials");
  MeshContext context;
  for (size_t i = 0; i < materials.size(); ++i)
    context.uses_of_material.push_back(uv_uses(materials[i], path_to("materials", i)));
  for (size_t i = 0; i < meshes.size(); ++i) {
    const std::string path = path_to("meshes", i);
    const Json& primitives = list(meshes[i], "primitives");
    const auto target_count = [&](size_t k) { return list(primitives[k], "targets").size(); };
    for (size_t k = 0; k < primitives.size(); ++k) {
      const std::string here = path_to(path, "primitives", k);
      PrimitiveCheck(asset, context, primitives[k], here).check();
      check_variants(asset, primitives[k], here);
      if (target_count(k) != target_count(0))
        asset.add(path_to(here, "targets"),
                  "all primitives of a mesh need as many morph targets as its first");
    }
    const Json& weights = list(meshes[i], "weights");
    if (!weights.empty() && !primitives.empty() && weights.size() != target_count(0))
      asset.add(path_to(path, "weights"), "has " + std::to_string(weights.size()) + " items for " +
                                              std::to_string(target_count(0)) + " morph targets");
  }
  for (const auto& [view, paths] : context.accessors_of_view) {
    if (paths.size() < 2 || has(asset.list_of("bufferViews")[view], "byteStride")) continue;
    for (const auto& [accessor, path] : paths)
      asset.add(path, "shares " + path_to("bufferViews", view) + ", which needs a byteStride");
  }
}

}  // namespace lueur::conformance
