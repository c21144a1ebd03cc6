// SPDX-License-Identifier: MIT
// Light and ambient occlusion from the camera's own G-buffer, with a bit mask of the directions
// that samples have covered.
//
// O. Therrien, Y. Levesque, G. Gilet: "Screen Space Indirect Lighting with Visibility Bitmask", The
// Visual Computer, 2023.
//
// A pixel's hemisphere is cut into slices around the direction to the eye. In each, samples along a
// line of the screen, from near to far, cover the directions between the front of what they hit and
// its back, `thickness_m` behind as the eye sees it. 32 sectors of the slice are covered or open;
// those that a sample newly covers see it:
//
//   E/pi(x) = sum over slices  w_s  sum over samples  L_i n_i / 32,     sum over slices  w_s = 1,
//
// n_i being the number of sectors, L_i the sample's source radiance where it faces x, 0 where not,
// and w_s the cosine-weighted solid angle of the slice. Sectors have equal shares of that, so that
// light of 1 from all sides adds up to 1. Occlusion is the share of sectors open to what is nearer
// than `distance_m`.
//
// What differs from the paper: its sectors are of equal angle and each sample is multiplied by the
// cosine at the receiver, which adds up to 1 for no hemisphere; it also multiplies by the cosine at
// the emitter (`emitter_cosine`), which a sector's solid angle holds already; its back lies behind
// the sample along the receiver's direction to the eye, and not its own. And it leaves open what
// lies between two samples of one surface; here the second one covers that, too (`bridge`), if the
// first is within `thickness_m` of its plane.
#pragma once

#include "lueur/technique.h"

namespace lueur {

struct VisibilityBitmaskSettings {
  // Over how many pixels a side, of one surface. Of occlusion, which varies less, at most three.
  enum class Filter : int32_t { none, three, nine };

  int32_t slices = 3;
  int32_t samples = 16;  // on each side of a slice
  float radius_m = 10.0f;
  float distance_m = 1.0f;
  float thickness_m = 0.3f;
  bool bridge = true;
  bool emitter_cosine = false;
  Filter filter = Filter::nine;
};

// Outputs: `diffuse`, its alpha without meaning, and `occlusion`.
//
// Needs depth, normal and source of the camera. What it does not see neither shines nor blocks.
class VisibilityBitmask final : public Technique {
 public:
  explicit VisibilityBitmask(VisibilityBitmaskSettings settings = {}) : settings_(settings) {}
  Outputs render(Frame& frame, const Inputs& inputs) override;
  void* settings() override { return &settings_; }

  static std::span<const SettingInfo> settings_table();

 private:
  VisibilityBitmaskSettings settings_;
};

}  // namespace lueur
