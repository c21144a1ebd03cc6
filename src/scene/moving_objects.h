// SPDX-License-Identifier: MIT
// Which of a scene's instances move, and which of them belong together.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/scene.h"

namespace lueur {

// As many as lueur/host.h can name.
inline constexpr int32_t kMostMovingObjects = 255;

struct MovingObjects {
  std::vector<int32_t> of_instance;  // by Scene::instances: index of the object; kNone: none
  int32_t count = 0;
};

// All that hangs below one node is one object, where animation moves that node and none above it.
// An instance whose skin or morph targets alone move is an object by itself. Objects come in the
// order of their first instances; those after kMostMovingObjects are taken for standing still.
MovingObjects moving_objects(const Scene& scene);

// Around all instances of each object; `of_instance` is from bounds_of_instances() (deform.h).
std::vector<Bounds> bounds_of_objects(const MovingObjects& objects,
                                      std::span<const Bounds> of_instance);

}  // namespace lueur
