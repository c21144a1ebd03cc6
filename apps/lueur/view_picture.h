// SPDX-License-Identifier: MIT
// An image of a pass, whatever it holds, as something that a person can look at.
#pragma once

#include "frame/recorder.h"
#include "image/image.h"
#include "image/tone_map.h"

namespace lueur::cli {

// What an image holds is told by its name, the part after the last dot of "pass.image":
//   normal               x, y, z from [-1, 1] to red, green, blue; two channels are octahedral
//   geometry             the same, black where nothing is
//   depth, shadow_map    the value, the image's largest being white; so is object
//   motion               x, y to red, green around grey, the image's largest being 0 or 1
//   albedo               as a white light would show it
//   occlusion            the value, as a white light would show it
//   base_color, material the stored values
//   anything else        light: exposed and tone mapped like the picture
Image8 view_picture(const Pixels& pixels, float exposure_ev, ToneMap tone_map);

}  // namespace lueur::cli
