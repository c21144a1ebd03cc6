// SPDX-License-Identifier: MIT
#include "scene/gltf_load.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <string>
#include <utility>

#include "base/try.h"
#include "scene/conformance/conformance.h"
#include "scene/deform.h"
#include "scene/gltf_animation.h"
#include "scene/gltf_file.h"
#include "scene/gltf_instance.h"
#include "scene/gltf_material.h"
#include "scene/gltf_mesh.h"
#include "scene/gltf_node.h"
#include "scene/gltf_texture.h"

namespace lueur {
namespace {

Result<void> warn_of_extensions(const GltfFile& file, Warnings& warnings) {
  const JsonCursor top = file.root();
  LUEUR_TRY(used, top.texts("extensionsUsed"));
  for (const std::string& extension : used) {
    if (!is_supported(extension))
      warnings.add(printable(extension) + " is not supported: drawn without it");
  }
  return {};
}

// Reads the meshes that the scene's nodes use, each once, and places an instance for each use.
class InstanceReader {
 public:
  InstanceReader(const GltfFile& file, const NodeTree& tree, GltfMaterials& materials,
                 Warnings& warnings, Scene& scene)
      : file_(&file),
        tree_(&tree),
        materials_(&materials),
        warnings_(&warnings),
        scene_(&scene),
        place_of_mesh_(file.size_of("meshes"), kUnread),
        place_of_skin_(file.size_of("skins"), kUnread),
        budget_{file.limits().vertices, file.limits().indices} {}

  Result<void> read() {
    const JsonCursor top = file_->root();
    LUEUR_TRY(nodes, top.array("nodes"));
    for (size_t i = 0; i < tree_->nodes.size(); ++i) {
      LUEUR_TRY(node, nodes.element(static_cast<size_t>(tree_->file_nodes[i])));
      LUEUR_TRY_VOID(read_node(node, static_cast<int32_t>(i)));
    }
    if (scene_->instances.empty())
      warnings_->add("the scene has no triangles: there is nothing to draw");
    return {};
  }

 private:
  static constexpr int32_t kUnread = -2;

  Result<void> read_node(const JsonCursor& at, int32_t node) {
    LUEUR_TRY(file_mesh, at.index("mesh", place_of_mesh_.size(), "meshes"));
    if (file_mesh == kNone) return {};
    LUEUR_TRY(place, mesh(file_mesh));
    if (place == kNone) return {};
    const Mesh& drawn = scene_->meshes[static_cast<size_t>(place)];

    MeshInstance instance{.node = node, .mesh = place};
    LUEUR_TRY(weights, read_morph_weights(*file_, at, file_mesh, drawn));
    instance.morph_weights = std::move(weights);
    LUEUR_TRY(passes_light_on, read_passes_light_on(at));
    instance.passes_light_on = passes_light_on;
    LUEUR_TRY(copies, read_copies(*file_, at, file_->limits().nodes - scene_->nodes.size()));
    const size_t count = std::max(copies.size(), size_t{1});
    if (!drawn.morph_targets.empty())
      LUEUR_TRY_VOID(spend(at, drawn.vertices.size() + drawn.morph_targets.size(), count));
    LUEUR_TRY(file_skin, at.index("skin", place_of_skin_.size(), "skins"));
    if (file_skin != kNone && drawn.influences.empty()) {
      warnings_->add("a mesh without joints has a skin: drawn where its node is");
    } else if (file_skin != kNone) {
      LUEUR_TRY(of_instance, skin(file_skin));
      const Skin& follows = scene_->skins[static_cast<size_t>(of_instance)];
      LUEUR_TRY_VOID(spend(at, drawn.vertices.size() + follows.joints.size(), count));
      LUEUR_TRY_VOID(check_fit(at, drawn, follows));
      instance.skin = of_instance;
    }

    if (copies.empty()) scene_->instances.push_back(std::move(instance));
    for (Node& copy : copies) {
      copy.parent = node;
      instance.node = static_cast<int32_t>(scene_->nodes.size());
      scene_->nodes.push_back(std::move(copy));
      scene_->instances.push_back(instance);
    }
    return {};
  }

  // Each instance that deforms has vertices of its own, so that a few nodes can ask for more memory
  // than all meshes; its joints and weights, too, take time with each.
  Result<void> spend(const JsonCursor& at, uint64_t cost, size_t count) {
    if (cost > budget_.vertices / count)
      return at.error("with its skins and morph targets the scene has more than " +
                      std::to_string(file_->limits().vertices) +
                      " vertices, of which each node has its own; use fewer nodes");
    budget_.vertices -= cost * count;
    return {};
  }

  // The place in the scene of a mesh of the file; kNone where there is nothing to draw.
  Result<int32_t> mesh(int32_t file_mesh) {
    int32_t& place = place_of_mesh_[static_cast<size_t>(file_mesh)];
    if (place != kUnread) return place;
    LUEUR_TRY(mesh, read_mesh(*file_, file_mesh, *materials_, budget_, *warnings_));
    place = mesh.primitives.empty() ? kNone : static_cast<int32_t>(scene_->meshes.size());
    if (place != kNone) scene_->meshes.push_back(std::move(mesh));
    return place;
  }

  Result<int32_t> skin(int32_t file_skin) {
    int32_t& place = place_of_skin_[static_cast<size_t>(file_skin)];
    if (place != kUnread) return place;
    LUEUR_TRY(skin, read_skin(*file_, file_skin, *tree_));
    place = static_cast<int32_t>(scene_->skins.size());
    scene_->skins.push_back(std::move(skin));
    return place;
  }

  const GltfFile* file_;
  const NodeTree* tree_;
  GltfMaterials* materials_;
  Warnings* warnings_;
  Scene* scene_;
  std::vector<int32_t> place_of_mesh_;
  std::vector<int32_t> place_of_skin_;
  GeometryBudget budget_;
};

Error beyond_floats(const GltfFile& file, const Mesh& mesh) {
  return {ErrorKind::input, file.name() + ": the vertices of mesh " + in_quotes(mesh.name) +
                                " lie beyond the range of 32-bit floats in the world; scale the "
                                "model down"};
}

// Finite vertices and a finite transform can still multiply to infinity.
Result<void> refuse_infinite_vertices(const GltfFile& file, const Scene& scene) {
  std::vector<glm::vec3> reach;  // of each mesh from its origin along each axis
  for (const Mesh& mesh : scene.meshes) {
    glm::vec3 largest(0.0f);
    for (const Vertex& vertex : mesh.vertices)
      largest = glm::max(largest, glm::abs(vertex.position));
    reach.push_back(largest);
  }
  const std::vector<glm::mat4> world_from_node = pose(scene, 0.0f);
  for (const MeshInstance& instance : scene.instances) {
    const glm::mat4& world = world_from_node[static_cast<size_t>(instance.node)];
    glm::vec3 bound = glm::abs(glm::vec3(world[3]));
    for (int axis = 0; axis < 3; ++axis)
      bound += glm::abs(glm::vec3(world[axis])) * reach[static_cast<size_t>(instance.mesh)][axis];
    if (!std::isfinite(bound.x + bound.y + bound.z))
      return beyond_floats(file, scene.meshes[static_cast<size_t>(instance.mesh)]);
  }
  for (const DeformedInstance& deformed : deformed_instances(scene, world_from_node, 0.0f)) {
    const MeshInstance& instance = scene.instances[deformed.instance];
    const glm::mat4 world = world_from_instance(instance, world_from_node);
    for (const Vertex& vertex : deformed.vertices) {
      const glm::vec4 at = world * glm::vec4(vertex.position, 1.0f);
      if (!std::isfinite(at.x + at.y + at.z))
        return beyond_floats(file, scene.meshes[static_cast<size_t>(instance.mesh)]);
    }
  }
  return {};
}

Result<Scene> read_scene(Result<GltfFile> opened, const std::filesystem::path& path) {
  LUEUR_TRY(file, std::move(opened));
  Warnings warnings;
  for (const std::string& fault : conformance_faults(file)) warnings.add(fault);
  LUEUR_TRY_VOID(warn_of_extensions(file, warnings));
  GltfTextures textures(file, warnings);
  GltfMaterials materials(file, textures, warnings);

  Scene scene;
  scene.name = path.stem().string();
  LUEUR_TRY(tree, read_nodes(file));
  scene.nodes = tree.nodes;
  LUEUR_TRY_VOID(InstanceReader(file, tree, materials, warnings, scene).read());
  LUEUR_TRY(cameras, read_cameras(file, tree, warnings));
  LUEUR_TRY(lights, read_lights(file, tree, warnings));
  LUEUR_TRY(animation, read_animation(file, tree, warnings));
  LUEUR_TRY_VOID(refuse_infinite_vertices(file, scene));
  // Decode last: only what the meshes turned out to use.
  LUEUR_TRY(decoded, textures.decode());
  scene.cameras = std::move(cameras);
  scene.lights = std::move(lights);
  scene.animation = std::move(animation);
  LUEUR_TRY(used_materials, materials.take(decoded));
  scene.materials = std::move(used_materials);
  scene.textures = std::move(decoded);
  scene.warnings = warnings.take();
  return scene;
}

Error out_of_memory(const std::string& name) {
  return {ErrorKind::memory, name + ": not enough memory to load it"};
}

}  // namespace

Result<Scene> load_gltf(const std::filesystem::path& path, const LoadLimits& limits) {
  // Catch here what the parser and the containers may throw: no exception leaves this folder.
  try {
    return read_scene(GltfFile::open(path, limits), path);
  } catch (const std::bad_alloc&) {
    return out_of_memory(path.string());
  }
}

Result<Scene> decode_gltf(std::vector<uint8_t> bytes, const std::string& name,
                          const LoadLimits& limits) {
  try {
    return read_scene(GltfFile::from_bytes(std::move(bytes), name, limits), name);
  } catch (const std::bad_alloc&) {
    return out_of_memory(name);
  }
}

}  // namespace lueur
