// SPDX-License-Identifier: MIT
#include "image/tone_map.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace lueur {
namespace {

using Rgb = std::array<float, 3>;
using Matrix = std::array<Rgb, 3>;  // rows

constexpr float kBrightest = 65504.0f;  // bounds every curve; the largest half float

Rgb operator*(const Matrix& m, const Rgb& v) {
  Rgb result;
  for (size_t row = 0; row < 3; ++row)
    result[row] = m[row][0] * v[0] + m[row][1] * v[1] + m[row][2] * v[2];
  return result;
}

template <class F>
Rgb each(const Rgb& v, F function) {
  return {function(v[0]), function(v[1]), function(v[2])};
}

// Written so that NaN, which compares false with everything, becomes 0.
float exposed(float sample, float scale) {
  const float value = sample * scale;
  return value > 0.0f ? std::min(value, kBrightest) : 0.0f;
}

float clamp01(float value) {
  return value > 0.0f ? std::min(value, 1.0f) : 0.0f;
}

Rgb encode(const Rgb& linear) {
  return each(linear, [](float value) { return srgb_from_linear(clamp01(value)); });
}

// Stephen Hill's fit (2016, published with MJP's BakingLab). The first matrix goes from Rec.709 to
// the desaturated AP1 primaries in which the RRT works, the second one back.
Rgb aces_display(const Rgb& color) {
  constexpr Matrix kRrtFromRec709 = {{{0.59719f, 0.35458f, 0.04823f},
                                      {0.07600f, 0.90834f, 0.01566f},
                                      {0.02840f, 0.13383f, 0.83777f}}};
  constexpr Matrix kRec709FromOdt = {{{1.60475f, -0.53108f, -0.07367f},
                                      {-0.10208f, 1.10813f, -0.00605f},
                                      {-0.00327f, -0.07276f, 1.07602f}}};
  const auto rrt_and_odt = [](float x) {
    return (x * (x + 0.0245786f) - 0.000090537f) / (x * (0.983729f * x + 0.4329510f) + 0.238081f);
  };
  return encode(kRec709FromOdt * each(kRrtFromRec709 * color, rrt_and_odt));
}

// Troy Sobotka's AgX (2022): mix the primaries so that saturated light has a way to white, take the
// logarithm from 10 stops below to 6.5 stops above middle grey, and apply a sigmoid. The sigmoid is
// the sixth-order polynomial of Benjamin Wrensch, "Minimal AgX Implementation" (2022), whose mean
// squared error is 3.7e-6. What comes out is display-encoded already.
Rgb agx_display(const Rgb& color) {
  constexpr Matrix kInset = {{{0.842479062253094f, 0.0784335999999992f, 0.0792237451477643f},
                              {0.0423282422610123f, 0.878468636469772f, 0.0791661274605434f},
                              {0.0423756549057051f, 0.0784336f, 0.879142973793104f}}};
  constexpr Matrix kOutset = {{{1.19687900512017f, -0.0980208811401368f, -0.0990297440797205f},
                               {-0.0528968517574562f, 1.15190312990417f, -0.0989611768448433f},
                               {-0.0529716355144438f, -0.0980434501171241f, 1.15107367264116f}}};
  const auto curve = [](float x) {
    constexpr float kMinEv = -12.47393f;
    constexpr float kMaxEv = 4.026069f;
    const float ev = x > 0.0f ? std::clamp(std::log2(x), kMinEv, kMaxEv) : kMinEv;
    const float t = (ev - kMinEv) / (kMaxEv - kMinEv);
    constexpr std::array<float, 7> kPolynomial = {15.5f,   -40.14f, 31.96f,   -6.868f,
                                                  0.4298f, 0.1191f, -0.00232f};
    float y = 0.0f;
    for (const float coefficient : kPolynomial) y = y * t + coefficient;
    return y;
  };
  return each(kOutset * each(kInset * color, curve), clamp01);
}

// Khronos PBR Neutral Tone Mapper, specification 1.0; the names are those of its formulas.
Rgb khronos_neutral_display(const Rgb& color) {
  constexpr float kF90 = 0.04f;  // Fresnel reflection of white light that base colours carry
  constexpr float kStart = 0.8f - kF90;
  constexpr float kDesaturation = 0.15f;

  // Take the Fresnel part off, so that a base colour under white light comes out as it was painted.
  const float x = std::min({color[0], color[1], color[2]});
  const float offset = x < 2.0f * kF90 ? x - x * x / (4.0f * kF90) : kF90;
  const Rgb plain = each(color, [&](float value) { return value - offset; });
  const float peak = std::max({plain[0], plain[1], plain[2]});
  if (peak < kStart) return encode(plain);

  // Compress what is left above the start into [start, 1], and let it fade to white.
  constexpr float kRange = 1.0f - kStart;
  const float new_peak = 1.0f - kRange * kRange / (peak + kRange - kStart);
  const float to_white = 1.0f - 1.0f / (kDesaturation * (peak - new_peak) + 1.0f);
  return encode(each(
      plain, [&](float value) { return std::lerp(value * new_peak / peak, new_peak, to_white); }));
}

Rgb display(const Rgb& color, ToneMap tone_map) {
  switch (tone_map) {
    case ToneMap::none:
      return encode(color);
    case ToneMap::aces:
      return aces_display(color);
    case ToneMap::agx:
      return agx_display(color);
    case ToneMap::khronos_neutral:
      return khronos_neutral_display(color);
  }
  LUEUR_CHECK(false);
  return {};
}

uint8_t code_value(float encoded) {
  return static_cast<uint8_t>(std::lround(encoded * 255.0f));
}

}  // namespace

float srgb_from_linear(float linear) {
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

float linear_from_srgb(float encoded) {
  return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

Image8 to_display(const ImageF& image, float exposure_ev, ToneMap tone_map) {
  LUEUR_CHECK(image.channels == 1 || image.channels == 3 || image.channels == 4);
  LUEUR_CHECK_OP(image.samples.size(), ==, size_t{image.width} * image.height * image.channels);
  const float scale = std::exp2(exposure_ev);
  const size_t green = image.channels == 1 ? 0 : 1;
  const size_t blue = image.channels == 1 ? 0 : 2;

  Image8 result;
  result.width = image.width;
  result.height = image.height;
  result.channels = image.channels == 4 ? 4 : 3;
  result.samples.resize(size_t{image.width} * image.height * result.channels);
  uint8_t* out = result.samples.data();
  for (size_t i = 0; i < image.samples.size(); i += image.channels) {
    const float* pixel = &image.samples[i];
    const Rgb color = {exposed(pixel[0], scale), exposed(pixel[green], scale),
                       exposed(pixel[blue], scale)};
    for (const float value : display(color, tone_map)) *out++ = code_value(value);
    if (image.channels == 4) *out++ = code_value(clamp01(pixel[3]));
  }
  return result;
}

}  // namespace lueur
