// SPDX-License-Identifier: MIT
#include "moving_shot.h"

#include "arguments.h"
#include "base/try.h"

namespace lueur::cli {

Result<float> parse_rate(std::string_view flag, std::string_view text) {
  constexpr float kMostFramesASecond = 1e6f;
  LUEUR_TRY(rate, parse_real(flag, text, kMostFramesASecond));
  if (!(rate >= 1.0f))
    return Error{ErrorKind::usage, std::string(flag) + " '" + std::string(text) +
                                       "': expected 1 frame a second or more"};
  return rate;
}

float time_of(const Pace& pace, int32_t frame) {
  return static_cast<float>(static_cast<double>(pace.from_s) +
                            frame / static_cast<double>(pace.rate));
}

Shot moving_shot(const Pace& pace, const FrameSetup& setup, const Cameras& cameras, int32_t frame) {
  return {.extent = setup.size,
          .camera = cameras.main,
          .time_s = time_of(pace, frame),
          .previous_time_s = time_of(pace, frame - 1),
          .seed = setup.seed + (pace.fixed_seed ? 0u : static_cast<uint32_t>(frame)),
          .side_cameras = cameras.side};
}

}  // namespace lueur::cli
