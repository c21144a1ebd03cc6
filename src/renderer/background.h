// SPDX-License-Identifier: MIT
// The scene's environment in the device's memory, and the pass that shows it behind everything.
#pragma once

#include <optional>

#include "frame/recorder.h"
#include "gpu/system.h"
#include "lueur/view.h"
#include "scene/scene.h"

namespace lueur {

class Background {
 public:
  // Uploads the environment in half floats: radiance above 65504 is cut off. Pictures wider than
  // 8192 pixels lose what is finer.
  static Result<Background> create(gpu::System& system, Context& context,
                                   const Environment& environment);

  // Writes what `view` sees of it to the pixels of `composed` where `depth` is 0.
  void record(Recorder& frame, const View& view, Image depth, Image composed) const;
  // An image of what `view` sees of it, with nothing in front: rgba16f.
  Image alone(Recorder& frame, const View& view, Extent extent) const;

 private:
  Background() = default;
  void show(Recorder& frame, const std::string& pass, const View& view, const Bound& depth,
            Image shown) const;

  gpu::Texture texture_;
  uint32_t first_level_ = 0;  // of the picture's, the texture's finest
  Environment environment_;   // without its pixels
};

}  // namespace lueur
