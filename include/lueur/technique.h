// SPDX-License-Identifier: MIT
// What all techniques have in common: what they take, what they give, and the list of them.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "lueur/context.h"
#include "lueur/settings.h"
#include "lueur/view.h"

namespace lueur {

// The camera's G-buffer, all images of one extent W x H from 1x1 to the device's limit.
struct GBuffer {
  Image depth;   // d32f or r32f: as the view's projection yields it; cleared where nothing is
  Image normal;  // two channels, [-1, 1]: unit normal in world space, octahedral (see
                 // shading/packing.h)
  // rgba16f or rgba32f, alpha ignored: diffuse outgoing radiance, i.e. albedo x direct irradiance
  // / pi + emission. No specular reflection, no fog, no sky: what is not a surface has to be 0.
  Image source;
};

struct Inputs {
  View view;
  GBuffer g_buffer;
  // Chooses the pattern of samples: the same seed gives the same bits. For an animation, count it
  // up.
  uint32_t seed = 0;
};

// Per pixel of the G-buffer, linear, in the radiance unit of `source`. What a technique does not
// compute is invalid.
struct Outputs {
  // rgba16f. rgb = E/pi, the indirect irradiance over pi, before albedo: the host composes
  // `direct + albedo * diffuse + specular`. What alpha holds is told by the technique.
  Image diffuse;
  Image specular;   // rgba16f: outgoing indirect radiance through the glossy lobe, BRDF applied
  Image occlusion;  // r16f: 1 open, 0 closed
};

class Technique {
 public:
  virtual ~Technique() = default;
  // Records all passes into the frame. Failures are told by Frame::finish().
  virtual Outputs render(Frame& frame, const Inputs& inputs) = 0;
  // The settings structure that the technique's table describes.
  virtual void* settings() = 0;
};

struct TechniqueInfo {
  std::string_view name;
  std::string_view summary;  // one sentence
  std::string_view source;   // the paper
  std::span<const SettingInfo> settings;
  std::unique_ptr<Technique> (*make)();
};

// Every technique of the library, one row each.
std::span<const TechniqueInfo> techniques();
// The row of this name, or nullptr.
const TechniqueInfo* find_technique(std::string_view name);

}  // namespace lueur
