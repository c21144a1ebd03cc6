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

constexpr uint32_t kThreads = 64;  // of a workgroup, which makes a texel

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

  frame.dispatch("cube_maps.texels",
                 {.shader = shaders::cube_maps_texels_comp,
                  .params = TexelsParams{screen_of_view(view, extent), corner, factor,
                                         capture.far_m, background.valid() ? 1u : 0u},
                  .read = {{"depth", g.depth},
                           {"source", g.source},
                           {"background", background.valid() ? background : g.source}},
                  .write = {{"texels", texels}},
                  .over = {kThreads * capture.side, capture.side}});
  host.give_back_all(public_frame, g);
  if (background.valid()) host.give_back(public_frame, background);
}

}  // namespace lueur
