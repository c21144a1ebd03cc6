// SPDX-License-Identifier: MIT
// Horizon-based ambient occlusion: how far what the camera sees around a point closes it in.
//
// L. Bavoil, M. Sainz, R. Dimitrov: "Image-Space Horizon-Based Ambient Occlusion", SIGGRAPH Talks,
// 2008.
//
// A pixel's hemisphere is cut into slices around the direction to the eye. In each, samples along a
// line of the screen find on either side the horizon, the smallest angle from the direction to the
// eye at which something is; what lies below is closed:
//
//   occlusion(x) = sum over slices  w_s  (integral from h_1 to h_2 of |sin h| cos(h - gamma) dh)
//                                      / (the same over the whole hemisphere),   sum of w_s = 1,
//
// h_1 < 0 < h_2 being the horizons, gamma the angle of the normal projected onto the slice, and w_s
// the slice's cosine-weighted solid angle.
//
// What differs: Bavoil et al. sum up sin h - sin t, t being the angle of the tangent, over the
// directions around the normal and weight each horizon by 1 - (r / radius)^2. Here the integral
// over a slice is that of the cosine-weighted visibility, exactly, as in J. Jimenez, X. Wu, A.
// Pesce, A. Jarabo: "Practical Real-Time Strategies for Accurate Indirect Occlusion", 2016, so that
// the result is that of the reference `ambient` where surfaces are a height field. What a sample
// closes fades out over the last `falloff` of the radius alone. There is no angle bias, as a
// pixel's plane meets the line where it should.
#pragma once

#include "lueur/technique.h"

namespace lueur {

struct HbaoSettings {
  int32_t slices = 3;
  int32_t samples = 8;  // on each side of a slice
  float radius_m = 1.0f;
  float falloff = 0.1f;
  bool filter = true;
};

// Outputs: `occlusion`.
//
// Needs depth and normal of the camera. What it does not see does not close in, and what it sees
// counts as reaching down without end.
class Hbao final : public Technique {
 public:
  explicit Hbao(HbaoSettings settings = {}) : settings_(settings) {}
  Outputs render(Frame& frame, const Inputs& inputs) override;
  void* settings() override { return &settings_; }

  static std::span<const SettingInfo> settings_table();

 private:
  HbaoSettings settings_;
};

}  // namespace lueur
