// SPDX-License-Identifier: MIT
// Solid voxels of what a view sees: a grid of the view's frustum that tells where there is matter,
// and its coarser levels (FDP section 4, after Eisemann and Décoret 2008).
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "frame/recorder.h"
#include "lueur/triangles.h"
#include "shading/screen.h"

namespace lueur {

enum class Voxelizer : uint8_t {
  compute,  // rasterizes in a compute shader, toggles one bit a crossing and scans the columns
  raster,   // draws with the logic operation XOR, as in the paper; needs Recorder::has_logic_op()
};

struct VoxelizeInfo {
  std::span<const TriangleBatch> triangles;
  glm::mat4 view_from_world{1.0f};
  // Of level 0: pixel position p lies on the ray p * ray_scale + ray_offset. The rest is not used.
  Screen screen{};
  // rgba32f, of level 0's extent. Its w is the distance along the optical axis of what the pixel
  // sees, 0 for nothing: the grid reaches from the nearest of them to the farthest.
  Image geometry;
  uint32_t slices = 128;  // in depth: 32, 64, 128, 256 or 512
  uint32_t levels = 1;
  Voxelizer voxelizer = Voxelizer::compute;
};

// One bit a voxel, 32 of them a word. Word w of pixel (x, y) is texel (x, y * slices / 32 + w) of
// its level's image; its bit b is slice 32 w + b, counted from the eye. What is outside of the
// image is read as 0 in shaders: air.
struct VoxelGrid {
  std::vector<Image> levels;    // r32ui, slices / 32 times as high as the level
  std::vector<Extent> extents;  // of the levels, pixels
  BufferRef range;              // a VoxelRange (slices.h), storage buffer
  uint32_t slices = 0;
};

// Records the passes `voxels.*`. Fails the frame (ErrorKind::usage) where the device cannot have
// an image that high, or has no logic operations for Voxelizer::raster.
//
// A range of closed triangles is solid between its surfaces, seen from an eye in the air: along a
// pixel's ray, each surface toggles between air and matter. What is behind the eye, or behind the
// grid, does not count. Shells are as thick as the slices that they cross within a pixel.
VoxelGrid voxelize(Recorder& frame, const VoxelizeInfo& info);

}  // namespace lueur
