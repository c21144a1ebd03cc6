// SPDX-License-Identifier: MIT
// Light that the camera's picture lacks, from a cube map around the eye.
#include <glm/gtc/type_ptr.hpp>

#include "cube_maps/cube_capture.h"
#include "cube_maps/texel_lights.h"
#include "lights/square_views.h"
#include "techniques/hierarchical/hierarchical_frame.h"
#include "techniques/hierarchical/shaders.h"

namespace lueur::hierarchical {
namespace {

constexpr uint32_t kSide = 8, kPicturePx = 128;

}  // namespace

Image HierarchicalFrame::with_off_screen(const Pyramid& pyramid, Image light) {
  Host& host = *inputs_.host;
  const glm::vec3 eye(pyramid.world_from_view[3]);
  const std::vector<View> faces = cube_views(eye);
  CubeAtlas atlas{frame_.image("texels", {6 * kSide, kSide}, kCubeTexelFormat), kSide, {}};
  const glm::mat4 view_from_world = glm::make_mat4(inputs_.view.view_from_world.data());
  std::vector<glm::mat4> from_faces;
  for (size_t i = 0; i < faces.size(); ++i) {
    capture_face(public_frame_, host, faces[i],
                 {.picture_px = kPicturePx, .side = kSide, .far_m = far_of(host.bounds())},
                 atlas.texels, {static_cast<int>(i * kSide), 0});
    from_faces.push_back(view_from_world * world_from_face(faces[i]));
  }
  atlas.from_faces = frame_.upload(from_faces);
  const BufferRef texels =
      frame_.buffer("texel_lights", uint64_t{atlas.texels_a_map()} * sizeof(TexelLight));
  place_texels(frame_, "hierarchical.off_screen_texels", atlas, 0, texels);
  frame_.release(atlas.texels);

  const Level& level = pyramid.finest();
  const uint32_t pixels_per_thread = frame_.runs_on_cpu() ? 8 : 2;
  const Image more = frame_.image("light", level.extent, Format::rgba16f);
  frame_.dispatch(
      "hierarchical.off_screen",
      {.shader = shaders::techniques_hierarchical_off_screen_comp,
       .constants = {{"pixels_per_thread", pixels_per_thread}},
       .params = OffScreenParams{level.screen, pyramid.screen, as_ivec2(level.extent),
                                 as_ivec2(pyramid.g_buffer.depth.extent), atlas.texels_a_map()},
       .read = {{"geometry", level.geometry}, {"light", light}, {"texels", texels}},
       .write = {{"more", more}},
       .over = {level.extent.width, divide_up(level.extent.height, pixels_per_thread)}});
  frame_.release(light);
  return more;
}

}  // namespace lueur::hierarchical
