// SPDX-License-Identifier: MIT
// What the passes get from the CPU.
#ifndef LUEUR_HIERARCHICAL_PARAMS_H
#define LUEUR_HIERARCHICAL_PARAMS_H

#include "shading/cosine_lobe.h"
#include "shading/screen.h"

LUEUR_NAMESPACE_BEGIN

// See bilateral_weight(). More than kFlatness, for points of two frames: objects come nearer
// meanwhile.
const float kSameSurface = 0.05f;

// How many standard deviations of its neighbours light may lie off their mean.
const float kClampSpread = 1.5f;

struct PrepareParams {
  Screen screen;
  mat3 view_from_world;  // rotation, for normals
  ivec2 full_extent;     // of the G-buffer, pixels
  ivec2 extent;          // of the level that is written
};

struct DownsampleParams {
  Screen screen;    // of the level that is written
  vec2 fine_scale;  // ray_scale of the level that is read
  ivec2 fine_extent;
  ivec2 extent;
};

struct GatherParams {
  Screen screen;  // of the level that gives
  ivec2 extent;   // of the level that receives
  ivec2 source_extent;
  float inner_px;
  float outer_px;
  // Solid area that a sample stands for at z = 1, over pi:
  // ring area / samples * |ray_scale.x * ray_scale.y| / pi, of the level.   HSSIL (2)
  float area_over_pi;
  uint samples;
  uint level;
  uint seed;
  uint rotate;        // 0 or 1
  int march_steps;    // at most, of a ray through voxels
  float march_scale;  // pixels of the voxels' level a side of one of the giving level
};

struct GatherViewParams {
  GatherParams gather;
  Screen receiver_screen;
  mat4 source_from_receiver;  // view spaces
  uint is_first;              // 1: nothing was gathered before
};

struct LobeParams {
  Screen screen;  // of the full image
  ivec2 full_extent;
  ivec2 extent;  // of level 0
};

struct AlbedoParams {
  ivec2 full_extent;
  ivec2 extent;
};

struct ReflectParams {
  ivec2 extent;
  float own_weight;  // 1: on top of the source that is there, 0: alone
};

struct DownsampleSourceParams {
  ivec2 fine_extent;
  ivec2 extent;
};

struct AddParams {
  ivec2 extent;
};

struct UpsampleParams {
  Screen screen;      // of the fine level
  vec2 coarse_scale;  // ray_scale of the coarse level
  ivec2 extent;       // fine, pixels
  ivec2 coarse_extent;
  float own_weight;  // 1: add the fine level's own light, 0: do not
};

struct WarpParams {
  Screen screen;    // of the full image, now
  Screen previous;  // and in the frame before
  mat4 previous_view_from_view;
  ivec2 full_extent;
  ivec2 extent;  // of level 0
  float most;    // the largest weight
};

struct WarpViewParams {
  Screen screen;         // of level 0, here
  Screen screen_there;   // and of the other view
  mat4 there_from_here;  // view spaces
  ivec2 extent;
};

struct TemporalParams {
  ivec2 extent;
  uint has_light;    // 1, or 0: this frame has none, the last one's stays
  uint has_history;  // 1, or 0: nothing is known of the last frame
};

struct OutputParams {
  Screen screen;  // of the full image
  mat3 view_from_world;
  vec2 coarse_scale;
  ivec2 extent;  // of the full image
  ivec2 coarse_extent;
  float alpha_scale;  // 1 / number of levels gathered
};

struct OffScreenParams {
  Screen screen;          // of level 0
  Screen picture_screen;  // of the G-buffer
  ivec2 extent;           // of level 0
  ivec2 picture_extent;   // of the G-buffer
  uint texels;
};

LUEUR_NAMESPACE_END

#endif
