// SPDX-License-Identifier: MIT
#include "scene/gltf_instance.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <string>
#include <utility>

#include "base/try.h"
#include "scene/gltf_accessor.h"

namespace lueur {
namespace {

constexpr uint32_t kMatrixNumbers = 16;

// A finite array of `components` numbers an element, named `key` at `at`.
Result<std::vector<float>> read_finite(const GltfFile& file, const JsonCursor& at, const char* key,
                                       uint32_t components, uint64_t least, uint64_t most) {
  std::vector<float> nothing;
  LUEUR_TRY(accessor, at.index(key, file.size_of("accessors"), "accessors"));
  if (accessor == kNone) return nothing;
  LUEUR_TRY(shape, accessor_shape(file, accessor));
  if (shape.components != components)
    return at.error(key, "has to have " + std::to_string(components) + " components");
  if (shape.count < least || shape.count > most)
    return at.error(key, std::to_string(shape.count) + " elements, there have to be " +
                             std::to_string(least) + " to " + std::to_string(most) +
                             "; re-export the file");
  LUEUR_TRY(values, read_floats(file, accessor));
  for (const float value : values)
    if (!std::isfinite(value)) return at.error(key, "holds a value that is not finite");
  return std::move(values);
}

}  // namespace

Result<Skin> read_skin(const GltfFile& file, int32_t index, const NodeTree& tree) {
  const JsonCursor top = file.root();
  LUEUR_TRY(skins, top.array("skins"));
  LUEUR_TRY(at, skins.element(static_cast<size_t>(index)));
  Skin skin;
  LUEUR_TRY(name, at.text("name", ""));
  skin.name = name;
  LUEUR_TRY(joints, at.indices("joints", file.size_of("nodes"), "nodes"));
  if (joints.empty()) return at.error("joints", "has to name at least one node");
  for (const int32_t joint : joints) {
    const int32_t node = tree.node_of_file_node[static_cast<size_t>(joint)];
    if (node == kNone)
      return at.error("joints",
                      "node " + std::to_string(joint) + " is not in the scene; re-export the file");
    skin.joints.push_back(node);
  }
  LUEUR_TRY(numbers, read_finite(file, at, "inverseBindMatrices", kMatrixNumbers, joints.size(),
                                 file.limits().nodes));
  skin.joint_from_mesh.assign(joints.size(), glm::mat4(1.0f));
  if (!numbers.empty())
    for (size_t j = 0; j < joints.size(); ++j)
      skin.joint_from_mesh[j] = glm::make_mat4(numbers.data() + kMatrixNumbers * j);
  return skin;
}

Result<void> check_fit(const JsonCursor& node, const Mesh& mesh, const Skin& skin) {
  uint32_t last_joint = 0;
  for (const JointInfluence& influence : mesh.influences)
    for (int k = 0; k < 4; ++k) last_joint = std::max<uint32_t>(last_joint, influence.joints[k]);
  if (last_joint < skin.joints.size()) return {};
  return node.error("skin", "the mesh follows joint " + std::to_string(last_joint) +
                                ", the skin has " + std::to_string(skin.joints.size()) +
                                "; re-export the file");
}

Result<std::vector<float>> read_morph_weights(const GltfFile& file, const JsonCursor& node,
                                              int32_t file_mesh, const Mesh& mesh) {
  std::vector<float> weights(mesh.morph_targets.size(), 0.0f);
  if (weights.empty()) return weights;
  LUEUR_TRY(of_node, node.numbers("weights", weights));
  if (of_node) return weights;
  const JsonCursor top = file.root();
  LUEUR_TRY(meshes, top.array("meshes"));
  LUEUR_TRY(at, meshes.element(static_cast<size_t>(file_mesh)));
  LUEUR_TRY_VOID(at.numbers("weights", weights));
  return weights;
}

Result<bool> read_passes_light_on(const JsonCursor& node) {
  if (!node.has("extras")) return true;
  const JsonCursor extras = node.member("extras");
  return extras.boolean(kPassesLightOnKey, true);
}

Result<std::vector<Node>> read_copies(const GltfFile& file, const JsonCursor& node, uint64_t most) {
  constexpr const char* kExtension = "EXT_mesh_gpu_instancing";
  std::vector<Node> copies;
  LUEUR_TRY(extensions, node.object("extensions"));
  if (!extensions.has(kExtension)) return copies;
  LUEUR_TRY(at, extensions.object(kExtension));
  LUEUR_TRY(attributes, at.object("attributes"));
  LUEUR_TRY(translations, read_finite(file, attributes, "TRANSLATION", 3, 1, most));
  LUEUR_TRY(rotations, read_finite(file, attributes, "ROTATION", 4, 1, most));
  LUEUR_TRY(scales, read_finite(file, attributes, "SCALE", 3, 1, most));
  const size_t count = std::max({translations.size() / 3, rotations.size() / 4, scales.size() / 3});
  for (const auto& [size, components] :
       {std::pair(translations.size(), 3), {rotations.size(), 4}, {scales.size(), 3}})
    if (size != 0 && size != count * static_cast<size_t>(components))
      return attributes.error("its accessors differ in their count; re-export the file");

  copies.resize(count);
  for (size_t i = 0; i < count; ++i) {
    if (!translations.empty()) copies[i].translation = glm::make_vec3(&translations[3 * i]);
    if (!scales.empty()) copies[i].scale = glm::make_vec3(&scales[3 * i]);
    if (rotations.empty()) continue;
    const float* q = &rotations[4 * i];
    const glm::quat rotation(q[3], q[0], q[1], q[2]);
    if (!(glm::length(rotation) > 0.0f))
      return attributes.error("ROTATION", "holds a rotation of length 0; re-export the file");
    copies[i].rotation = glm::normalize(rotation);
  }
  return copies;
}

}  // namespace lueur
