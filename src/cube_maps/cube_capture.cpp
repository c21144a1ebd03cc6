// SPDX-License-Identifier: MIT
#include "cube_maps/cube_capture.h"

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>

#include "base/check.h"
#include "cube_maps/params.h"
#include "cube_maps/shaders.h"
#include "frame/screen_of_view.h"

namespace lueur {
namespace {

// Pixels that a thread adds up, a side: more would leave too few threads.
constexpr uint32_t kMostASide = 16;

}  // namespace

float far_of(const Box& bounds) {
  const glm::vec3 low = glm::make_vec3(bounds.min.data()), high = glm::make_vec3(bounds.max.data());
  return std::clamp(2.0f * glm::length(high - low), 1.0f, 1e6f);
}

void capture_face(Frame& public_frame, Host& host, const View& view, const CubeCapture& capture,
                  Image texels, glm::ivec2 corner) {
  Recorder& frame = public_frame.recorder();
  const uint32_t factor = capture.picture_px / capture.side;
  LUEUR_CHECK(factor * capture.side == capture.picture_px);
  const Extent extent{capture.picture_px, capture.picture_px};
  const GBuffer g = host.render_view(public_frame, view, extent, {.without = capture.without});
  if (!g.depth.valid() || !g.source.valid())
    return frame.fail({ErrorKind::usage, "the engine gives no G-buffer of other views"});
  const Image background = host.background(public_frame, view, extent);

  const uint32_t first_factor = std::min(factor, kMostASide);
  const bool in_one_step = first_factor == factor;
  const uint32_t first_side = capture.picture_px / first_factor;
  const Image first =
      in_one_step ? texels : frame.image("finer", {first_side, first_side}, kCubeTexelFormat);
  frame.dispatch("cube_maps.texels",
                 {.shader = shaders::cube_maps_texels_comp,
                  .params = TexelsParams{screen_of_view(view, extent), ivec2(int(first_side)),
                                         in_one_step ? corner : ivec2(0), int(first_factor),
                                         capture.far_m, background.valid() ? 1u : 0u},
                  .read = {{"depth", g.depth},
                           {"source", g.source},
                           {"background", background.valid() ? background : g.source}},
                  .write = {{"texels", first}},
                  .over = {first_side, first_side}});
  host.give_back_all(public_frame, g);
  if (background.valid()) host.give_back(public_frame, background);
  if (in_one_step) return;
  frame.dispatch("cube_maps.average", {.shader = shaders::cube_maps_average_comp,
                                       .params = AverageParams{ivec2(int(capture.side)), corner,
                                                               int(factor / first_factor)},
                                       .read = {{"finer", first}},
                                       .write = {{"texels", texels}},
                                       .over = {capture.side, capture.side}});
  frame.release(first);
}

}  // namespace lueur
