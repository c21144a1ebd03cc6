// SPDX-License-Identifier: MIT
// Hierarchical screen-space indirect illumination.
//
// C. Soler, O. Hoel, F. Rochet, N. Holzschuch: "Hierarchical Screen-Space Indirect Illumination for
// Video Games", INRIA RR-7162, 2009 (HSSIL). Ring radii as in the follow-up by Soler, Hoel and
// Rochet, "A Fast Deferred Shading Pipeline for Real Time Approximate Indirect Illumination" (FDP).
//
// Each visible point gathers light from other visible points, near ones at full detail and far ones
// from coarser levels of the G-buffer:
//
//   diffuse(x) = sum over samples i of  L_i v_i R_i^2 cos+(theta_i) / (r_i^2 + R_i^2),
//   R_i^2 = cos+(theta'_i) ds_i / pi,                                                  HSSIL (4)
//   ds_i = z_i^2 * 4 tan(fov_h / 2) tan(fov_v / 2) / (W H) * cos(alpha) / cos(beta) * dP_i  (2)
//
// v_i is found in voxels, or taken as 1. What the camera does not see gives no light, unless
// sources are taken from the lights' own views.
#pragma once

#include "lueur/technique.h"

namespace lueur {

struct HierarchicalSettings {
  enum class Start : int32_t { full, half, quarter };
  enum class Pyramid : int32_t { closest, vote };
  enum class Visibility : int32_t { none, first_bounce, all_bounces };
  enum class VoxelSlices : int32_t { of_32, of_64, of_128, of_256, of_512 };
  enum class Voxelizer : int32_t { compute, raster };
  enum class Sources : int32_t { camera, lights };
  enum class OffScreen : int32_t { none, map };
  enum class SideViews : int32_t { gather, warp };
  enum class FormFactor : int32_t { disc, point };
  enum class Sampling : int32_t { sparse, every_pixel };

  Start start = Start::half;
  Pyramid pyramid = Pyramid::closest;
  int32_t levels = 6;
  int32_t samples = 64;
  int32_t sample_growth = 4;
  float radius = 20.0f;  // pixels of the level
  FormFactor form_factor = FormFactor::disc;
  Sampling sampling = Sampling::sparse;
  bool rotate = true;
  bool filter = true;
  Visibility visibility = Visibility::none;
  VoxelSlices voxel_slices = VoxelSlices::of_128;
  int32_t visibility_steps = 8;
  int32_t visibility_finer = 8;
  Voxelizer voxelizer = Voxelizer::compute;
  Sources sources = Sources::camera;
  int32_t light_view_px = 512;
  OffScreen off_screen = OffScreen::none;
  SideViews side_views = SideViews::gather;
  bool glossy = false;
  int32_t glossy_samples = 32;
  bool glossy_importance = true;
  float temporal = 0.9f;
  bool temporal_clamp = false;
  int32_t bounces = 1;
  bool interleave = false;
  bool feedback = false;
  int32_t only_level = 0;
};

// Outputs: `diffuse`, and `specular` with Settings::glossy. The alpha of each, "off_screen", is the
// share of samples that fell outside of the image, averaged over the levels: light that may be
// missing there.
//
// What of Inputs it needs beyond view, depth, normal and source depends on the settings: motion for
// all that remembers (temporal, feedback, interleave; without it the temporal filter rests), albedo
// for more than one bounce, reflectance and lobes for glossy, emission and a host for
// sources=lights, a host for off_screen=map, a host's triangles for visibility. render() fails the
// frame (ErrorKind::usage) where something else than the filter's motion is missing.
//
// Memory at half start: about 8 bytes a pixel of W x H for the pyramid, 5 for light on its way, 8
// for what it remembers, and 8 for the output; kept between frames.
class Hierarchical final : public Technique {
 public:
  explicit Hierarchical(HierarchicalSettings settings = {}) : settings_(settings) {}
  Outputs render(Frame& frame, const Inputs& inputs) override;
  void* settings() override { return &settings_; }

  static std::span<const SettingInfo> settings_table();

 private:
  HierarchicalSettings settings_;
  uint64_t frames_ = 0;  // recorded
};

// Samples that a pixel takes at `level`, counted from 0 for the finest.
uint32_t samples_at_level(const HierarchicalSettings& settings, uint32_t level);

}  // namespace lueur
