// SPDX-License-Identifier: MIT
// What all techniques have in common: what they take, what they give, and the list of them.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <utility>

#include "lueur/context.h"
#include "lueur/g_buffer.h"
#include "lueur/host.h"
#include "lueur/result.h"
#include "lueur/settings.h"
#include "lueur/view.h"

namespace lueur {

struct Inputs {
  View view;
  GBuffer g_buffer;
  // Chooses the pattern of samples: the same seed gives the same bits. For an animation, count it
  // up.
  uint32_t seed = 0;

  // The view of the frame before, to which `g_buffer.motion` leads. `cut`: that frame showed
  // something else, and nothing of it shall last.
  View previous_view{};
  bool cut = false;
  // What g_buffer.reflectance points at. Valid while the technique records.
  std::span<const CosineLobe> lobes{};
  // Other cameras whose pictures may hold light that the main one does not see.
  std::span<const View> side_views{};
  // What a technique asks for more than that; nullptr: it does without.
  Host* host = nullptr;
};

// Per pixel of the G-buffer, linear, in the radiance unit of `source`. What a technique does not
// compute is invalid.
struct Outputs {
  // rgba16f. rgb = E/pi, the indirect irradiance over pi, before albedo: the host composes
  // `direct + albedo * diffuse + specular`. What alpha holds, TechniqueInfo says.
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

// Settings that go together: values by name, as in set_from_text(). What it does not name has its
// default.
struct Preset {
  std::string_view name;
  std::string_view summary;  // one sentence
  std::span<const std::pair<std::string_view, std::string_view>> settings;
};

struct TechniqueInfo {
  std::string_view name;
  std::string_view summary;  // one sentence
  std::string_view source;   // the paper
  // What the alpha of `Outputs::diffuse` holds, as a name in snake_case that is no other layer's of
  // the program's EXR files; empty: nothing. What the name means its README says, but for
  // "off_screen": the share of the technique's samples that fell outside of the picture.
  std::string_view diffuse_alpha;
  std::span<const SettingInfo> settings;
  std::unique_ptr<Technique> (*make)();
  std::span<const Preset> presets{};
};

// Every technique of the library, one row each.
std::span<const TechniqueInfo> techniques();
// The row of this name, or nullptr.
const TechniqueInfo* find_technique(std::string_view name);

// Gives all of the technique's settings, those of `info`, the values of the preset. Fails
// (ErrorKind::usage) on a name that it does not have; the message lists those it has.
Result<void> apply_preset(const TechniqueInfo& info, std::string_view preset, void* settings);

}  // namespace lueur
