// SPDX-License-Identifier: MIT
// Gives a scene what its file left out, so that there is something to see.
#pragma once

#include "scene/scene.h"

namespace lueur {

// A scene without a camera gets one: inside, with the longest free view, if the scene is a place
// with walls around; before the missing wall of a room that lacks one; otherwise outside, a little
// above, with the whole scene in view and 5 % to spare at an aspect ratio of 4:3 or wider.
//
// A scene without lights gets one, unless it has an environment, or surfaces that shine on their
// own: then its direct light is what they show of themselves, and all else of it is indirect, which
// a line in the warnings says. Surfaces shine when their flux, spread over the surface of the
// scene's box, is at least 2 % of the light that would be added; small lamps and displays do not.
// What is added is a sun from above the camera's left shoulder on objects; in
// places with walls a sun that reaches the floor if there is a way in, and a point light below the
// ceiling if there is none. The brightest places get about pi lux: white paper there reflects 1
// cd/m².
//
// Each addition is a node of its own and says so in Scene::warnings.
void complete(Scene& scene);

}  // namespace lueur
