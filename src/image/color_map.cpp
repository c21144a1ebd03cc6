// SPDX-License-Identifier: MIT
#include "image/color_map.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace lueur {
namespace {

// Every eighth of the map's entries 0 to 255, in code values. The last stands for entry 256, one
// past the end.
constexpr float kEntriesApart = 8.0f;
constexpr std::array<std::array<float, 3>, 33> kMagma = {
    {{0.4f, 0.1f, 3.5f},       {3.5f, 3.0f, 17.5f},      {10.1f, 7.9f, 34.0f},
     {18.9f, 13.3f, 51.7f},    {28.8f, 16.7f, 70.6f},    {40.5f, 17.4f, 89.9f},
     {54.0f, 15.8f, 106.8f},   {67.7f, 15.4f, 117.8f},   {80.7f, 18.3f, 123.8f},
     {93.3f, 23.0f, 127.0f},   {105.8f, 28.2f, 128.7f},  {118.2f, 33.1f, 129.5f},
     {130.8f, 37.8f, 129.5f},  {143.5f, 42.2f, 128.7f},  {156.5f, 46.4f, 127.1f},
     {169.6f, 50.5f, 124.7f},  {182.7f, 54.8f, 121.2f},  {195.7f, 59.6f, 116.7f},
     {208.3f, 65.3f, 111.3f},  {220.1f, 72.4f, 105.2f},  {230.6f, 81.5f, 99.0f},
     {239.0f, 93.1f, 94.0f},   {245.0f, 106.7f, 91.7f},  {249.1f, 121.4f, 92.9f},
     {251.6f, 136.6f, 97.5f},  {253.2f, 151.7f, 104.6f}, {254.0f, 166.7f, 113.8f},
     {254.3f, 181.5f, 124.5f}, {254.2f, 196.2f, 136.4f}, {253.8f, 210.9f, 149.4f},
     {253.1f, 225.5f, 163.2f}, {252.3f, 240.1f, 177.9f}, {251.6f, 254.6f, 193.0f}}};

}  // namespace

std::array<uint8_t, 3> magma(float value) {
  const float position = value > 0.0f ? std::min(value, 1.0f) * 255.0f / kEntriesApart : 0.0f;
  const auto first = static_cast<size_t>(position);
  std::array<uint8_t, 3> color;
  for (size_t c = 0; c < 3; ++c)
    color[c] = static_cast<uint8_t>(std::lround(
        std::lerp(kMagma[first][c], kMagma[first + 1][c], position - static_cast<float>(first))));
  return color;
}

Image8 in_magma(const ImageF& plane) {
  LUEUR_CHECK_OP(plane.channels, ==, 1u);
  Image8 picture{plane.width, plane.height, 3, {}};
  picture.samples.reserve(plane.samples.size() * 3);
  for (const float value : plane.samples)
    for (const uint8_t code : magma(value)) picture.samples.push_back(code);
  return picture;
}

}  // namespace lueur
