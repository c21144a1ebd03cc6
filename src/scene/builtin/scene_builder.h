// SPDX-License-Identifier: MIT
// Puts nodes, cameras, lights and their paths into a Scene; shared by all built-in scenes.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <string>

#include "scene/scene.h"

namespace lueur::builtin {

// Length of every loop in the built-in scenes.
inline constexpr float kLoopSeconds = 10.0f;

// The rotation that turns -z towards `direction` with +y as far up as possible.
glm::quat look_along(glm::vec3 direction);

int32_t add_node(Scene& scene, std::string name, glm::vec3 translation = glm::vec3(0.0f),
                 glm::quat rotation = glm::quat(1, 0, 0, 0), int32_t parent = kNone);

// A rough, non-metallic material.
int32_t add_material(Scene& scene, std::string name, glm::vec3 albedo, float roughness = 0.9f);

// Adds `mesh` and one instance of it on a new node of the same name.
int32_t add_mesh(Scene& scene, Mesh mesh);
void add_instance(Scene& scene, int32_t mesh, int32_t node);

int32_t add_camera(Scene& scene, std::string name, glm::vec3 eye, glm::vec3 target,
                   float vertical_fov_rad);

// A spotlight at `from` that gives `lux` on a surface at `to` that faces it; it fades from half its
// cone outwards. Returns its node.
int32_t add_spot_light(Scene& scene, std::string name, glm::vec3 from, glm::vec3 to,
                       glm::vec3 color, float lux, float outer_cone_rad);

// Key frames every 1/`keys` of the loop, the last equal to the first.
void animate_translation(Scene& scene, int32_t node, int keys,
                         const std::function<glm::vec3(float phase)>& translation);
void animate_rotation(Scene& scene, int32_t node, int keys,
                      const std::function<glm::quat(float phase)>& rotation);

// A camera ride: `eye` and `target` are periodic in the phase, [0, 1].
void animate_camera(Scene& scene, int32_t node, int keys,
                    const std::function<glm::vec3(float phase)>& eye,
                    const std::function<glm::vec3(float phase)>& target);

// Stops at which a diffuse surface of `albedo` under `illuminance_lux` shows as 0.9.
float exposure_for(float albedo, float illuminance_lux);

}  // namespace lueur::builtin
