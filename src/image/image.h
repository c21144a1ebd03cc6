// SPDX-License-Identifier: MIT
// A picture in memory: linear float samples, scene-referred unless a name says otherwise.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lueur {

// `channels` interleaved floats a pixel, row by row from the top left. Colours are linear Rec.709.
struct ImageF {
  uint32_t width = 0;
  uint32_t height = 0;
  uint32_t channels = 0;
  std::vector<float> samples;  // width * height * channels

  ImageF() = default;
  ImageF(uint32_t width_px, uint32_t height_px, uint32_t channel_count)
      : width(width_px),
        height(height_px),
        channels(channel_count),
        samples(size_t{width_px} * height_px * channel_count) {}

  float& at(uint32_t x, uint32_t y, uint32_t c) {
    return samples[(size_t{y} * width + x) * channels + c];
  }
  float at(uint32_t x, uint32_t y, uint32_t c) const {
    return samples[(size_t{y} * width + x) * channels + c];
  }
};

// One named layer of an EXR file, e.g. "indirect". Its channels are written as R, G, B, A for 3 and
// 4 channels, Z for a layer named "depth", X, Y, Z for one named "normal", Y for a main picture of
// one channel, and by number (0, 1, …) otherwise.
struct ImageLayer {
  std::string name;  // empty for the main picture
  ImageF image;
};

// 8 bits a channel, display-referred, as it is stored in a PNG.
struct Image8 {
  uint32_t width = 0;
  uint32_t height = 0;
  uint32_t channels = 0;  // 3 or 4
  std::vector<uint8_t> samples;
};

}  // namespace lueur
