// SPDX-License-Identifier: MIT
// A scene's geometry and textures in the device's memory, and the draws that show it.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "frame/recorder.h"
#include "gpu/system.h"
#include "renderer/lobe_table.h"
#include "renderer/params.h"
#include "scene/deform.h"
#include "scene/moving_objects.h"
#include "scene/scene.h"

namespace lueur {

// Triangles that bound solids, all about as thick.
struct SolidPart {
  uint32_t index_count = 0;
  float thickness_m = 0.0f;  // of the thinnest of them, as the mesh has it: scene/watertight.h
};

// A primitive of a mesh, for a run of instances that follow each other in the instance buffer.
struct DrawItem {
  uint32_t first_index = 0;
  uint32_t index_count = 0;
  int32_t vertex_offset = 0;
  uint32_t first_instance = 0;
  uint32_t instance_count = 0;
  int32_t material = 0;
  bool mirrored = false;  // the instances' transforms turn front faces into clockwise ones
  std::span<const SolidPart> solids;  // its first indices; what comes after them bounds nothing
};

// Where the scene's parts are at one time.
struct ScenePose {
  std::vector<glm::mat4> world_from_node;
  std::vector<DeformedInstance> deformed;
};

// What one frame draws, for its buffers.
struct FrameGeometry {
  std::vector<InstanceData> instances;
  std::vector<DeformedVertex> deformed;  // at least one
  std::vector<DrawItem> draws;
};

class SceneOnDevice {
 public:
  // Uploads everything, in batches, and waits for it.
  static Result<std::unique_ptr<SceneOnDevice>> create(gpu::System& system, Context& context,
                                                       const Scene& scene);

  // The frame's instances and draws, ordered by mesh. Both poses are of the scene given to
  // create().
  FrameGeometry pose(const ScenePose& now, const ScenePose& before) const;

  const gpu::Buffer& vertices() const { return vertices_; }
  const gpu::Buffer& indices() const { return indices_; }
  // Whether any material emits light, or shows its colour as if it did.
  bool emits() const { return emits_; }
  // Whether any instance keeps light that others pass on.
  bool keeps_light() const { return keeps_light_; }
  const MovingObjects& moving_objects() const { return moving_objects_; }
  const std::vector<MaterialData>& materials() const { return materials_; }
  const LobeTable& cosine_lobes() const { return cosine_lobes_; }
  MaterialSet material_set(int32_t material) const {
    return material_sets_[static_cast<size_t>(material)];
  }
  const Material& material(int32_t index) const {
    return scene_materials_[static_cast<size_t>(index)];
  }

 private:
  struct MeshRange {
    uint32_t first_index = 0;
    int32_t vertex_offset = 0;
  };
  struct Instance {
    MeshInstance placed;
    size_t index = 0;  // in Scene::instances
  };
  SceneOnDevice() = default;
  std::vector<DrawItem> draws(const std::vector<glm::mat4>& world_from_node) const;
  std::vector<std::vector<SolidPart>> solids_first(const Mesh& mesh,
                                                   std::span<uint32_t> indices) const;
  Result<void> upload_geometry(gpu::System& system, gpu::Device& device, const Scene& scene);
  Result<void> upload_textures(gpu::System& system, gpu::Device& device, const Scene& scene);
  void make_materials(Recorder& recorder, const Scene& scene);

  std::vector<Material> scene_materials_;
  std::vector<Instance> instances_;                          // ordered by mesh
  std::vector<std::vector<Primitive>> primitives_;           // by mesh
  std::vector<std::vector<std::vector<SolidPart>>> solids_;  // by mesh and primitive
  std::vector<MeshRange> meshes_;
  gpu::Buffer vertices_;
  gpu::Buffer indices_;
  // Each of the scene's textures as sRGB and as linear data; made only where a material uses it so.
  std::vector<gpu::Texture> srgb_textures_;
  std::vector<gpu::Texture> linear_textures_;
  gpu::Texture white_;
  std::vector<MaterialData> materials_;
  std::vector<MaterialSet> material_sets_;
  LobeTable cosine_lobes_;
  MovingObjects moving_objects_;
  bool emits_ = false;
  bool keeps_light_ = false;
};

// The vertex layouts of Scene's Vertex.
std::vector<gpu::VertexAttribute> g_buffer_attributes();
std::vector<gpu::VertexAttribute> shadow_attributes();

}  // namespace lueur
