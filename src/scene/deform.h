// SPDX-License-Identifier: MIT
// Meshes as skins and morph targets shape them at a time. Renderer and reference both take their
// vertices from here, so that they show the same geometry to the bit.
#pragma once

#include <span>
#include <vector>

#include "scene/scene.h"

namespace lueur {

// Whether the instance's vertices depend on more than its node.
bool is_deformed(const Scene& scene, const MeshInstance& instance);

// What takes the instance's vertices to world space: its node's matrix, and the identity where a
// skin has put them there.
glm::mat4 world_from_instance(const MeshInstance& instance,
                              const std::vector<glm::mat4>& world_from_node);

struct DeformedInstance {
  size_t instance = 0;           // in Scene::instances
  std::vector<Vertex> vertices;  // as many as its mesh has; in world space if it is skinned
};

// glTF 2.0, section 3.7: morph targets first, then the skin, whose joints' matrices are blended by
// weight. Normals follow by the blended matrix' cofactors; where a morph target has none, they stay
// as they are. A vertex that would leave the range of floats stays where the mesh has it.
// `world_from_node` is pose(scene, time_s).
std::vector<DeformedInstance> deformed_instances(const Scene& scene,
                                                 const std::vector<glm::mat4>& world_from_node,
                                                 float time_s);

// The box around what is drawn of each instance, in world space; finite, as it leaves out what is
// not. Around nothing, min is greater than max.
std::vector<Bounds> bounds_of_instances(const Scene& scene,
                                        const std::vector<glm::mat4>& world_from_node,
                                        const std::vector<DeformedInstance>& deformed);
// Around several of those; a point at the origin if there is nothing in any.
Bounds bounds_around(std::span<const Bounds> boxes);

// Around all that is drawn.
Bounds bounds(const Scene& scene, const std::vector<glm::mat4>& world_from_node,
              const std::vector<DeformedInstance>& deformed);
Bounds bounds_at(const Scene& scene, float time_s);

// The same scene with nothing left to deform: each deformed instance gets a mesh of its own, as it
// is at `time_s`, and a skinned one a node that leaves it where it is.
Scene with_deformed_meshes(Scene scene, float time_s);

}  // namespace lueur
