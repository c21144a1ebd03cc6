// SPDX-License-Identifier: MIT
// Triangles become a cloud of discs that all look equally large: BZB 4.1 and 4.3 (Nalbach,
// Ritschel, Seidel 2015), figure 6.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>

#include "frame/recorder.h"
#include "lueur/triangles.h"
#include "shading/screen.h"

namespace lueur {

struct SurfelizeInfo {
  std::span<const TriangleBatch> triangles;
  glm::mat4 view_from_world{1.0f};
  Screen screen{};  // of the picture
  Extent extent;    // of the picture, pixels
  // Of a surfel that is looked at straight on, in the middle of the picture. Elsewhere surfels of
  // the same distance from the eye are as large, and look larger by 1 / cos of the angle between
  // the optical axis and the way there.
  float radius_px = 4.0f;
  // How far from what the picture can show surfels are made, too.
  float margin_m = 1.0f;
  // What is nearer to the eye counts as so far away.
  float least_distance_m = 0.1f;
  // Room for parts of triangles and for surfels. What finds none is left out; see SurfelCloud.
  uint32_t parts_capacity = 1u << 20;
  uint32_t surfels_capacity = 1u << 20;
};

// A buffer of { uint count; Surfel surfels[] } (params.h): `count` may be more than there is room
// for, and tells then how many there would be. Their order changes from frame to frame, what and
// where they are only with triangles and eye.
struct SurfelCloud {
  BufferRef list;
  uint32_t capacity = 0;
};

// Records the passes `surfels.*`, a few for each batch. The total area of the surfels is that of
// the triangles near the view: each is a random sample, thin, tiny and huge triangles alike.
SurfelCloud surfelize(Recorder& frame, const SurfelizeInfo& info);

}  // namespace lueur
