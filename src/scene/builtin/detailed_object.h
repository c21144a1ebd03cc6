// SPDX-License-Identifier: MIT
// The detailed object of a scene, which a mesh of the user's can take the place of.
#pragma once

#include <cstdint>

#include "scene/scene.h"

namespace lueur::builtin {

struct DetailedObject {
  uint32_t triangles;  // met within 3 %
  float height_m;
};

// Adds the object, standing on the origin of `parent` and looking along its +z. Only one a scene.
void add_detailed_object(Scene& scene, const DetailedObject& object, int32_t parent);

// Whether `scene` has such an object.
bool has_detailed_object(const Scene& scene);

// Puts all that `other` draws, at rest, in the object's place: scaled as a whole to fit the
// object's box, upright on the same floor in the middle. Materials, textures and warnings come
// along; lights, cameras and animation do not. False, and nothing changes, if `other` draws nothing
// that has a size.
bool replace_detailed_object(Scene& scene, Scene other);

}  // namespace lueur::builtin
