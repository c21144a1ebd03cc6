// SPDX-License-Identifier: MIT
// Stops a part of a scene's animation, to tell what moves with the camera from what moves by
// itself.
#pragma once

#include "scene/scene.h"

namespace lueur {

// The camera stays where it is at `time_s`; everything else moves on.
void hold_camera(Scene& scene, int32_t camera, float time_s);

// Everything stays where it is at `time_s`, but the camera moves on.
void hold_all_but_camera(Scene& scene, int32_t camera, float time_s);

}  // namespace lueur
