// SPDX-License-Identifier: MIT
#include "view_picture.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "picture.h"
#include "shading/packing.h"

namespace lueur::cli {
namespace {

uint8_t code_value(float display) {
  // NaN fails the comparison and becomes 0.
  return display > 0.0f ? static_cast<uint8_t>(std::lround(std::min(display, 1.0f) * 255.0f)) : 0;
}

// Calls `color(samples of the pixel)`, which gives display values from 0 to 1.
template <class Color>
Image8 mapped(const Pixels& pixels, Color color) {
  Image8 image{pixels.extent.width, pixels.extent.height, 3, {}};
  const size_t count = size_t{image.width} * image.height;
  image.samples.resize(count * 3);
  for (size_t i = 0; i < count; ++i) {
    const vec3 display = color(&pixels.samples[i * pixels.channels]);
    for (int c = 0; c < 3; ++c)
      image.samples[i * 3 + static_cast<size_t>(c)] = code_value(display[c]);
  }
  return image;
}

// Grey for one channel; a missing third channel is 0.
vec3 three_channels(const float* samples, uint32_t channels) {
  if (channels == 1) return vec3(samples[0]);
  return {samples[0], samples[1], channels > 2 ? samples[2] : 0.0f};
}

// The largest finite magnitude, or 1 when there is none: what to divide by.
float largest(const Pixels& pixels) {
  float most = 0.0f;
  for (const float sample : pixels.samples)
    if (std::isfinite(sample)) most = std::max(most, std::abs(sample));
  return most > 0.0f ? most : 1.0f;
}

Image8 view_normal(const Pixels& pixels) {
  return mapped(pixels, [&](const float* s) {
    const vec3 n =
        pixels.channels == 2 ? octahedral_decode({s[0], s[1]}) : three_channels(s, pixels.channels);
    return 0.5f + 0.5f * n;
  });
}

Image8 view_geometry(const Pixels& pixels) {
  return mapped(pixels, [&](const float* s) {
    const vec3 n = three_channels(s, pixels.channels);
    return dot(n, n) > 0.0f ? 0.5f + 0.5f * n : vec3(0.0f);
  });
}

Image8 view_light(const Pixels& pixels, float exposure_ev, ToneMap tone_map) {
  ImageF light(pixels.extent.width, pixels.extent.height, 3);
  const size_t count = size_t{light.width} * light.height;
  for (size_t i = 0; i < count; ++i) {
    const vec3 color = three_channels(&pixels.samples[i * pixels.channels], pixels.channels);
    for (int c = 0; c < 3; ++c) light.samples[i * 3 + static_cast<size_t>(c)] = color[c];
  }
  return to_display(light, exposure_ev, tone_map);
}

}  // namespace

Image8 view_picture(const Pixels& pixels, float exposure_ev, ToneMap tone_map) {
  const std::string_view name =
      std::string_view(pixels.name).substr(pixels.name.find_last_of('.') + 1);
  const auto is = [&](std::string_view part) { return name.find(part) != std::string_view::npos; };
  if (is("normal")) return view_normal(pixels);
  if (is("geometry")) return view_geometry(pixels);
  if (is("albedo") || is("occlusion")) return view_light(pixels, 0.0f, ToneMap::none);
  if (is("base_color") || is("material"))
    return mapped(pixels, [&](const float* s) { return three_channels(s, pixels.channels); });
  if (is("depth") || is("shadow_map") || is("object")) {
    const float most = largest(pixels);
    return mapped(pixels, [&](const float* s) { return vec3(s[0] / most); });
  }
  if (is("motion")) {
    const float most = largest(pixels);
    return mapped(pixels, [&](const float* s) {
      return 0.5f + 0.5f / most * three_channels(s, pixels.channels);
    });
  }
  return view_light(pixels, exposure_ev, tone_map);
}

}  // namespace lueur::cli
