// SPDX-License-Identifier: MIT
// Texture look-ups as a GPU makes them: bilinear, between two levels, with the texture's wrapping.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "image/mip_chain.h"
#include "scene/scene.h"

namespace lueur::reference {

class TextureSampler {
 public:
  enum class Encoding : uint8_t { srgb, linear };

  // `texture` must outlive this.
  TextureSampler(const Texture& texture, Encoding encoding);

  // Linear RGBA at `uv`, in [0, 1], by the finest level alone.
  glm::vec4 finest(glm::vec2 uv) const { return bilinear(0, uv); }
  // The same between the levels for one pixel's step in uv to the right and down: the longer of the
  // two, in texels, picks the level.
  glm::vec4 filtered(glm::vec2 uv, glm::vec2 step_x, glm::vec2 step_y) const;
  // The mean over the whole texture.
  glm::vec4 mean() const;

 private:
  struct Level {
    int32_t width, height;
    const uint8_t* rgba;
  };
  glm::vec4 decoded(const uint8_t* texel) const;
  glm::vec4 bilinear(size_t level, glm::vec2 uv) const;

  std::vector<Level> levels_;
  std::vector<MipLevel> smaller_;  // what all levels but the first point into
  Encoding encoding_;
  Wrap wrap_u_, wrap_v_;
  bool nearest_;
};

}  // namespace lueur::reference
