// SPDX-License-Identifier: MIT
// Second-order illumination: indirect lights, and negative ones for what is blocked.
//
// R. Cochran, J. Steele: "Second-Order Illumination in Real-Time", ACMSE 2007 (SOL).
//
// Each of the engine's lights sends its flux out in N equal parts, in the directions of a Halton
// sequence that stays the same from frame to frame. Where one arrives there is an indirect light: a
// patch of the surface that reflects it. All points of the screen gather from all of them (3.2),
//
//   I_s(x) = sum over l of  L_l cos+(theta_l) cos+(theta) A_l / (pi (r^2 + A_l / pi)),
//   A_l = (Omega / N) d_l^2 / cos(theta_i),   L_l = albedo / pi * E_l,
//
// where Omega is the light's solid angle, d_l its distance and theta_i the angle at which it shines
// on the patch; A_l / pi beside r^2 is what bounds the inverse square (ours). Nothing is blocked so
// far. So M of the points that the camera sees become negative lights (3.3): what would reach them
// from behind, through the surface, goes on from there along its mean direction, negated:
//
//   I_c(x) ~ max(0, I_s(x) - I_n(x)).
//
// The gather is of a part of the pixels; the others are interpolated from those whose surface is
// theirs, or gathered too where there is none (3.5), from a list that stays on the device.
#pragma once

#include "lueur/technique.h"

namespace lueur {

struct IndirectLightsSettings {
  enum class LowResolution : int32_t { none, half, quarter };
  enum class Placing : int32_t { halton, random };

  int32_t lights = 300;           // N, shared out among the engine's lights by flux
  int32_t negative_lights = 150;  // M
  LowResolution low_resolution = LowResolution::half;
  float discontinuity = 0.1f;
  bool bound = true;
  int32_t light_view_px = 512;
  Placing placing = Placing::halton;
};

// Outputs: `diffuse`. Its alpha, "gathered", is 1 where a pixel was gathered for, 0 where it was
// interpolated.
//
// Needs a host that renders the views of its lights; of the camera, view, depth and normal. What
// emits, glossy reflection and further bounces give nothing. render() fails the frame
// (ErrorKind::usage) without such a host.
class IndirectLights final : public Technique {
 public:
  explicit IndirectLights(IndirectLightsSettings settings = {}) : settings_(settings) {}
  Outputs render(Frame& frame, const Inputs& inputs) override;
  void* settings() override { return &settings_; }

  static std::span<const SettingInfo> settings_table();

 private:
  IndirectLightsSettings settings_;
};

}  // namespace lueur
