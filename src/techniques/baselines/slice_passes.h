// SPDX-License-Identifier: MIT
// The passes before and after the gathering in slices.
#pragma once

#include <string>

#include "frame/recorder.h"
#include "lueur/technique.h"
#include "shading/screen.h"

namespace lueur {

class SlicePasses {
 public:
  // Passes are called `name`.geometry and so on. `inputs` must outlive this.
  SlicePasses(Recorder& frame, std::string name, const Inputs& inputs);

  const Screen& screen() const { return screen_; }
  Extent extent() const { return extent_; }

  // rgba32f: normal in view space and z, 0 where nothing is. Release it.
  Image geometry();
  // `light`, released, over 3 x 3 pixels of one surface, which interleave in slice_start().
  Image filter(Image geometry, Image light);
  // And then over the nine blocks around: 9 x 9.
  Image widen(Image geometry, Image light);
  // r16f: the alpha of `light`.
  Image occlusion(Image light);

 private:
  Image average(const char* pass, Image geometry, Image light, int32_t step_px);

  Recorder& frame_;
  std::string name_;
  const Inputs& inputs_;
  Extent extent_;
  Screen screen_;
};

}  // namespace lueur
