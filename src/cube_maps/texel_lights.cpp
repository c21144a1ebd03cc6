// SPDX-License-Identifier: MIT
#include "cube_maps/texel_lights.h"

#include <glm/gtc/type_ptr.hpp>

#include "cube_maps/shaders.h"
#include "frame/screen_of_view.h"
#include "lights/square_views.h"

namespace lueur {

glm::mat4 world_from_face(const View& face) {
  return glm::inverse(glm::make_mat4(face.view_from_world.data()));
}

PlaceParams place_params(const CubeAtlas& atlas, uint32_t map) {
  // All faces have one projection.
  return {screen_of_view(cube_views({}).front(), {atlas.side, atlas.side}),
          static_cast<int>(atlas.side), static_cast<int>(map), atlas.texels_a_map()};
}

void place_texels(Recorder& frame, const char* pass, const CubeAtlas& atlas, uint32_t map,
                  BufferRef lights) {
  frame.dispatch(pass, {.shader = shaders::cube_maps_place_comp,
                        .params = place_params(atlas, map),
                        .read = {{"atlas", atlas.texels}, {"faces", atlas.from_faces}},
                        .write = {{"texels", lights}},
                        .over = {atlas.texels_a_map(), 1}});
}

}  // namespace lueur
