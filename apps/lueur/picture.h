// SPDX-License-Identifier: MIT
// From the renderer's images, as they came back from the device, to pictures for files.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "frame/recorder.h"
#include "image/image.h"

namespace lueur::cli {

// Channels of all layers that exr_layers() makes.
inline constexpr uint32_t kExrChannels = 35;

// The image of this name, or nullptr.
const Pixels* find_pixels(std::span<const Pixels> all, std::string_view name);

// The first `channels` channels, as they are.
ImageF as_image(const Pixels& pixels, uint32_t channels);

// The layers of a rendered frame, from images named as in RenderedImages:
//   (main)      the composed picture, scene-referred
//   direct      source + specular: what there is without a technique
//   indirect    the technique's E/pi, before albedo
//   `diffuse_alpha`  its alpha, named as TechniqueInfo has it; left out where that is empty
//   indirect_specular  the technique's radiance through glossy lobes
//   occlusion   the technique's, 1 open, 0 closed
//   albedo      diffuse, linear
//   normal      unit, world space; 0 where nothing is
//   depth       distance along the optical axis in metres; 0 where nothing is
//   specular, emission, source   radiance
//   motion      UV now minus UV in the previous frame
//   material    metallic, perceptual roughness, share of dielectric F0
// Layers whose image is missing are left out. `near_m` is the camera's near plane.
std::vector<ImageLayer> exr_layers(std::span<const Pixels> all, float near_m,
                                   std::string_view diffuse_alpha);

// The mean of `indirect`'s alpha over the pixels that show something; none without such pixels, and
// where `diffuse_alpha` says that it is something else.
std::optional<double> off_screen_share(std::span<const Pixels> all, std::string_view diffuse_alpha);

}  // namespace lueur::cli
