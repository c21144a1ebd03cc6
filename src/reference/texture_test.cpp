// SPDX-License-Identifier: MIT
// Texture look-ups against texels written down by hand.
#include "reference/texture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "image/tone_map.h"

namespace lueur::reference {
namespace {

using enum TextureSampler::Encoding;

// One row of gray texels, opaque.
Texture row_of(std::initializer_list<int> values) {
  Texture texture{.width = static_cast<uint32_t>(values.size()), .height = 1};
  for (const int v : values)
    texture.rgba.insert(texture.rgba.end(), {static_cast<uint8_t>(v), static_cast<uint8_t>(v),
                                             static_cast<uint8_t>(v), 255});
  return texture;
}

float red(const Texture& texture, float u) {
  return TextureSampler(texture, linear).finest({u, 0.5f}).r * 255.0f;
}

TEST(TextureSampler, IsBilinearBetweenTexelCentres) {
  Texture texture = row_of({0, 100, 200, 40});
  texture.wrap_u = Wrap::clamp_to_edge;
  EXPECT_NEAR(red(texture, 0.375f), 100.0f, 1e-3f);
  EXPECT_NEAR(red(texture, 0.5f), 150.0f, 1e-3f);
  EXPECT_NEAR(red(texture, 0.4375f), 125.0f, 1e-3f);
  texture.nearest = true;
  EXPECT_NEAR(red(texture, 0.49f), 100.0f, 1e-3f);
  EXPECT_NEAR(red(texture, 0.51f), 200.0f, 1e-3f);
}

TEST(TextureSampler, Wraps) {
  Texture texture = row_of({10, 100, 200, 40});
  const float beyond[] = {-0.125f, 1.125f,     1.375f,    -0.375f,
                          2.125f,  -1000.875f, 4000.125f, 1e6f + 0.125f};
  const struct {
    Wrap wrap;
    float expected[8];
  } cases[] = {{Wrap::repeat, {40, 10, 100, 200, 10, 10, 10, 10}},
               {Wrap::mirrored_repeat, {10, 40, 200, 100, 10, 40, 10, 10}},
               {Wrap::clamp_to_edge, {10, 40, 40, 10, 40, 10, 40, 40}}};
  for (const bool nearest : {true, false})
    for (const auto& [wrap, expected] : cases) {
      texture.wrap_u = wrap;
      texture.nearest = nearest;
      for (size_t k = 0; k < 8; ++k)
        EXPECT_NEAR(red(texture, beyond[k]), expected[k], 0.01f)
            << "wrap " << static_cast<int>(wrap) << " at " << beyond[k];
    }
}

// Which way the halves of a texel mix across a seam shows the wrapping, too.
TEST(TextureSampler, MixesAcrossTheSeam) {
  Texture texture = row_of({0, 100, 200, 40});
  texture.wrap_u = Wrap::repeat;
  EXPECT_NEAR(red(texture, 0.0f), 20.0f, 1e-3f);
  EXPECT_NEAR(red(texture, 1.0f), 20.0f, 1e-3f);
  texture.wrap_u = Wrap::mirrored_repeat;
  EXPECT_NEAR(red(texture, 0.0f), 0.0f, 1e-3f);
  EXPECT_NEAR(red(texture, 1.0f), 40.0f, 1e-3f);
}

TEST(TextureSampler, NonsenseIsNoCrash) {
  const Texture texture = row_of({7, 7});
  for (const float u :
       {std::numeric_limits<float>::quiet_NaN(), INFINITY, -INFINITY, 3e38f, -3e38f})
    EXPECT_NEAR(red(texture, u), 7.0f, 1e-3f);
  const TextureSampler sampler(texture, linear);
  EXPECT_NEAR(sampler.filtered({0, 0}, {NAN, 0}, {0, 0}).r * 255.0f, 7.0f, 1e-3f);
  EXPECT_NEAR(sampler.filtered({0, 0}, {INFINITY, 0}, {0, 0}).r * 255.0f, 7.0f, 1e-3f);
}

TEST(TextureSampler, ColoursAreDecodedBeforeTheyAreMixed) {
  const Texture texture = row_of({0, 255});
  const TextureSampler sampler(texture, srgb);
  EXPECT_NEAR(sampler.finest({0.5f, 0.5f}).r, 0.5f, 1e-6f);
  const Texture gray = row_of({128});
  EXPECT_NEAR(TextureSampler(gray, srgb).finest({0, 0}).r, linear_from_srgb(128.0f / 255.0f),
              1e-6f);
  // Alpha is no colour.
  Texture faint = row_of({128});
  faint.rgba[3] = 128;
  EXPECT_NEAR(TextureSampler(faint, srgb).finest({0, 0}).a, 128.0f / 255.0f, 1e-6f);
}

// A step of 2^k texels reads level k as make_mip_chain() made it, one between reads both.
TEST(TextureSampler, StepsPickLevels) {
  Texture texture{.width = 16, .height = 8};
  std::mt19937 engine(2);
  for (int i = 0; i < 16 * 8 * 4; ++i) texture.rgba.push_back(static_cast<uint8_t>(engine()));
  const std::vector<MipLevel> chain = make_mip_chain(texture.rgba, 16, 8, false);
  const TextureSampler sampler(texture, linear);
  const auto texel = [&](size_t level, uint32_t x, uint32_t y) {
    const MipLevel& l = chain[level - 1];
    const uint8_t* t = &l.rgba[4 * (size_t{y} * l.width + x)];
    return glm::vec4(t[0], t[1], t[2], t[3]) / 255.0f;
  };
  const auto expect_near = [](const glm::vec4& a, const glm::vec4& b) {
    for (int c = 0; c < 4; ++c) EXPECT_NEAR(a[c], b[c], 1e-5f);
  };
  for (const bool down : {false, true}) {
    const auto filtered = [&](glm::vec2 uv, float texels) {
      const glm::vec2 across(texels / 16, 0), along(0, texels / 8);
      return down ? sampler.filtered(uv, across * 0.5f, along)
                  : sampler.filtered(uv, across, along * 0.5f);
    };
    const glm::vec2 at_1(5.5f / 8, 2.5f / 4), at_2(1.5f / 4, 0.5f / 2);
    expect_near(filtered(at_1, 2), texel(1, 5, 2));
    expect_near(filtered(at_2, 4), texel(2, 1, 0));
    expect_near(filtered(at_1, 1e6f), texel(4, 0, 0));
    // Half way in powers of two; at a centre of level 1 level 2 is a mix of its own.
    expect_near(filtered(at_1, 2 * std::sqrt(2.0f)),
                0.5f * (filtered(at_1, 2) + filtered(at_1, 4)));
    // Magnified: the finest.
    expect_near(filtered(at_1, 0.3f), sampler.finest(at_1));
  }
  expect_near(sampler.mean(), texel(4, 0, 0));
}

}  // namespace
}  // namespace lueur::reference
