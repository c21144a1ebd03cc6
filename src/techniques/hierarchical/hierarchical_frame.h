// SPDX-License-Identifier: MIT
// One frame of the technique: the steps that render() is made of. Each records passes and gives
// images, which the caller releases;
// what a step is given stays the caller's.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "frame/recorder.h"
#include "lueur/hierarchical.h"
#include "techniques/hierarchical/params.h"

namespace lueur::hierarchical {

using Settings = HierarchicalSettings;

// One level of a pyramid.
struct Level {
  Extent extent;
  Screen screen;   // ray_scale is a level pixel's
  Image geometry;  // see pyramid.glsl
  Image source;    // radiance, foreshortening; see pyramid.glsl
  Image voxels;    // invalid: there are none
};

// A view's surfaces at all levels, the finest first.
struct Pyramid {
  GBuffer g_buffer;
  Screen screen;  // of the G-buffer
  mat4 view_from_world{1.0f};
  mat4 world_from_view{1.0f};
  int factor = 1;         // pixels of the G-buffer a side of one pixel of level 0
  bool is_dark = false;   // nothing in it is a source
  BufferRef voxel_range;  // of all levels' voxels
  std::vector<Level> levels;

  const Level& finest() const { return levels.front(); }
};

// Light on its way through the levels.
struct Gathered {
  Image light;          // at level 0: E/pi, and in alpha the sum of off-screen shares
  uint32_t levels = 0;  // that have gathered
  Image but_last{};     // the same without the last bounce; invalid: there was only one
};

// What a frame takes over from the one before, warped to this one: FDP (6), W(F).
struct Warped {
  Image light;  // rgb: F; a: the weight that it may have, 0 where nothing is known. Invalid: none
};

class HierarchicalFrame {
 public:
  HierarchicalFrame(Frame& frame, const Settings& settings, const Inputs& inputs)
      : public_frame_(frame), frame_(frame.recorder()), settings_(settings), inputs_(inputs) {}

  // --- pyramid.cpp: HSSIL 3.2, "mipmapping"

  // Level 0 of a view's pyramid, from the engine's images.
  struct Beginning {
    int factor = 1;              // pixels of the G-buffer a side of one of level 0
    bool keeps_history = false;  // the next frame will look at its geometry
    Image source{};              // what shines; invalid: nothing does
  };
  Pyramid begin_pyramid(const View& view, const GBuffer& g_buffer, const Beginning& how);
  // The coarser levels, until there are so many.
  void finish_pyramid(Pyramid& pyramid, uint32_t levels);
  // Voxels of what the view sees, for all levels.
  void voxelize(Pyramid& pyramid);
  // The mean albedo of level 0's pixels.
  Image albedo(const Pyramid& pyramid);
  // The same pyramid with another source at level 0, and what follows from it at the others. The
  // geometry is shared: only one of the two is to be released with release().
  Pyramid with_source(const Pyramid& pyramid, Image source);
  void release_sources(const Pyramid& pyramid);
  void release(const Pyramid& pyramid);

  // --- gather.cpp: HSSIL 3.2, "indirect lighting shader" and "continuous combination"

  // `blocked`: obstacles count, if there are voxels.
  Gathered gather_all_levels(const Pyramid& pyramid, bool blocked);
  // The light at the resolution of the view's G-buffer.
  Image output(const Pyramid& pyramid, const Gathered& gathered);

  // --- views.cpp: sources that other views see

  // The first bounce of all lights, at level 0, unfiltered.
  Gathered gather_from_lights(const Pyramid& receivers);
  // What side views add to this light of level 0: HSSIL 5, "additional cameras". Releases `light`.
  Image with_side_views(const Pyramid& pyramid, Image light);

  // --- off_screen.cpp: LCM (Szirmay-Kalos, Lazányi 2006)

  // What surfaces give that the eye would see beside the picture. Releases `light`.
  Image with_off_screen(const Pyramid& pyramid, Image light);

  // --- bounces.cpp: FDP, "multi-bounce computation"

  // All of Settings::bounces.
  Gathered gather_bounces(const Pyramid& pyramid, Image albedo);

  // One of two bounces, the other one from the frame before.
  Gathered gather_in_turn(const Pyramid& pyramid, Image albedo, bool second_bounce);
  // Adds what surfaces reflect of the last frame's light to the source of level 0, before
  // finish_pyramid().
  void feed_back(Pyramid& pyramid, Image albedo, const Warped& warped);

  // --- glossy.cpp: FDP, "screen-space importance sampling"

  // What the surfaces reflect through their glossy lobes, at the resolution of the view's G-buffer.
  // `diffuse` tells what they receive.
  Image glossy(const Pyramid& pyramid, Image albedo, const Gathered& diffuse);

  // --- temporal.cpp: FDP, "temporal filtering"

  // Which lobe each pixel of level 0 has, and the lobes that there are.
  struct Lobes {
    Image codes;
    BufferRef table;
  };

  bool has_history() const;
  // W(F) of what was kept under `name`. Comes once a frame and name, before blend() or carry().
  // `lobes`: of what comes through them; nullptr: of diffuse light.
  Warped warp(const Pyramid& pyramid, const std::string& name, const Lobes* lobes = nullptr);
  // FDP (6): kept for the next frame.
  Image blend(const Pyramid& pyramid, const std::string& name, const Warped& warped, Image light);
  // W(F) as it is: kept for the next frame.
  Image carry(const Pyramid& pyramid, const std::string& name, const Warped& warped);

 private:
  Lobes lobes_of(const Pyramid& pyramid);
  Pyramid pyramid_of_glossy_sources(const Pyramid& pyramid, Image albedo, Image light);
  Gathered gather_glossy(const Pyramid& pyramid, const Lobes& lobes);
  Image output_glossy(const Pyramid& pyramid, const Gathered& gathered);
  Pyramid pyramid_of_view(const View& view, Extent extent, int32_t light);
  Image gather_from_side_view(const Pyramid& pyramid, const View& view);
  Image warp_from_side_view(const Pyramid& pyramid, const View& view, Image light);
  void gather_from(const Pyramid& givers, const Pyramid& receivers, const std::string& pass,
                   Image indirect, bool is_first);
  GatherParams gather_params(const Level& level, uint32_t index, uint32_t samples) const;
  Gathered gather_first_bounce(const Pyramid& pyramid);
  Image gather(const Pyramid& pyramid, uint32_t index, bool blocked);
  uint32_t voxel_level(uint32_t level) const;
  Gathered gather_levels(const Pyramid& pyramid, const std::string& kind,
                         const std::function<Image(const Level&, uint32_t)>& gather_level);
  // These two release the light that they are given.
  Image filter(const Level& level, uint32_t index, const std::string& kind, Image light);
  Image combine(const Level& fine, uint32_t index, const Level& coarse, const std::string& kind,
                Image own, Image light);
  uint32_t gather_pixels_per_thread(Extent level, bool marches) const;
  // Fails the frame where the loops of a thread that marches would be cut short: `rays` for each of
  // the samples that `params` has.
  void check_rounds(const GatherParams& params, uint32_t rays);
  OutputParams output_params(const Pyramid& pyramid, const Gathered& gathered) const;
  bool further_are_blocked() const;
  uint32_t by_vote() const;
  Image reflect(const Pyramid& pyramid, Image albedo, Image light, bool on_top);
  Image add(const std::string& pass, Extent extent, Image a, Image b, bool take_larger = false);
  Image blend_with(const Pyramid& pyramid, const std::string& name, Image warped, Image light);

  Frame& public_frame_;
  Recorder& frame_;
  const Settings& settings_;
  const Inputs& inputs_;
  std::map<std::string, HistoryImage> light_history_;
  HistoryImage geometry_history_;  // of level 0 of the camera's own pyramid
};

// upsample.glsl takes one thread for each corner between coarse pixels, the image's edges included.
Extent corners_of(Extent coarse);
std::string at_level(const std::string& pass, uint32_t level);

}  // namespace lueur::hierarchical
