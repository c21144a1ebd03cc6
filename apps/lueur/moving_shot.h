// SPDX-License-Identifier: MIT
// The frames of an animation as an application renders them: one after the other, each with the
// time and the seed that follow from its number.
#pragma once

#include <string_view>

#include "frame_options.h"
#include "renderer/renderer.h"
#include "session.h"

namespace lueur::cli {

// Scenes are posed at float times. Below this those are 0.06 ms apart, well under a frame.
inline constexpr float kMostSeconds = 1000.0f;

struct Pace {
  float from_s = 0.0f;      // time of frame 0
  float rate = 60.0f;       // frames a second
  bool fixed_seed = false;  // all frames have the first one's
};

// Frames a second, 1 or more.
Result<float> parse_rate(std::string_view flag, std::string_view text);

// Seconds into the animation at which frame `frame` shows the scene; negative frames are those
// before the first.
float time_of(const Pace& pace, int32_t frame);

// Frame `frame` of the animation. Its time before is that of the frame before, its seed counts up
// with the frames unless it is fixed.
Shot moving_shot(const Pace& pace, const FrameSetup& setup, const Cameras& cameras, int32_t frame);

}  // namespace lueur::cli
