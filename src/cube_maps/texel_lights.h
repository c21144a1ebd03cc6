// SPDX-License-Identifier: MIT
// The texels of cube maps as surfaces that shine: LCM 4.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "cube_maps/equations.h"
#include "cube_maps/params.h"
#include "frame/recorder.h"
#include "lueur/view.h"

namespace lueur {

// Texels as capture_face() has written them: the faces of a map side by side, in the order of
// cube_views(), maps one below the other.
struct CubeAtlas {
  Image texels;
  uint32_t side = 0;  // of a face
  // Six mat4 a map: from the view space of each face to where positions shall be.
  BufferRef from_faces{};

  uint32_t texels_a_map() const { return 6 * side * side; }
};

glm::mat4 world_from_face(const View& face);

PlaceParams place_params(const CubeAtlas& atlas, uint32_t map);

// Writes the TexelLight of each texel of a map to `lights`.
void place_texels(Recorder& frame, const char* pass, const CubeAtlas& atlas, uint32_t map,
                  BufferRef lights);

}  // namespace lueur
