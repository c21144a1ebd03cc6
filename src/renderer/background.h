// SPDX-License-Identifier: MIT
// The scene's environment in the device's memory, and the pass that shows it behind everything.
#pragma once

#include <optional>

#include "frame/recorder.h"
#include "gpu/system.h"
#include "scene/scene.h"

namespace lueur {

class Background {
 public:
  // Uploads the environment in half floats: radiance above 65504 is cut off. Pictures wider than
  // 8192 pixels lose what is finer.
  static Result<Background> create(gpu::System& system, Context& context,
                                   const Environment& environment);

  // Writes the pixels of `composed` where `depth` is 0, for a camera of this vertical field of
  // view.
  void record(Recorder& frame, Extent extent, const glm::mat4& world_from_camera,
              float vertical_fov_rad, Image depth, Image composed) const;

 private:
  Background() = default;
  gpu::Texture texture_;
  uint32_t first_level_ = 0;  // of the picture's, the texture's finest
  Environment environment_;   // without its pixels
};

}  // namespace lueur
