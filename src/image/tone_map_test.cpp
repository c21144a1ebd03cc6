// SPDX-License-Identifier: MIT
#include "image/tone_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace lueur {
namespace {

using Code = std::array<int, 3>;

Code shown(float r, float g, float b, ToneMap tone_map, float exposure_ev = 0.0f) {
  ImageF image(1, 1, 3);
  image.samples = {r, g, b};
  const Image8 result = to_display(image, exposure_ev, tone_map);
  return {result.samples.at(0), result.samples.at(1), result.samples.at(2)};
}

int shown_grey(float y, ToneMap tone_map, float exposure_ev = 0.0f) {
  const Code code = shown(y, y, y, tone_map, exposure_ev);
  EXPECT_NEAR(code[0], code[1], 1);
  EXPECT_NEAR(code[0], code[2], 1);
  return code[0];
}

// The code value of a linear value, in double precision and straight from IEC 61966-2-1.
int code_of(double linear) {
  const double encoded =
      linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
  return static_cast<int>(std::lround(encoded * 255.0));
}

TEST(Srgb, KnownValues) {
  EXPECT_EQ(shown_grey(0.5f, ToneMap::none), 188);
  EXPECT_EQ(shown_grey(0.18f, ToneMap::none), 118);
  EXPECT_EQ(shown_grey(1.0f, ToneMap::none), 255);
  EXPECT_EQ(shown_grey(0.001f, ToneMap::none), 3);  // 12.92 · 0.001 · 255 = 3.29
}

TEST(Srgb, DecodingUndoesEncoding) {
  for (int code = 0; code <= 255; ++code) {
    const float encoded = static_cast<float>(code) / 255.0f;
    EXPECT_NEAR(srgb_from_linear(linear_from_srgb(encoded)), encoded, 1e-6f);
  }
}

TEST(ToneMap, NamesAreCompleteAndUnique) {
  std::set<std::string_view> names;
  std::set<ToneMap> maps;
  for (const ToneMapName& entry : kToneMapNames) {
    names.insert(entry.name);
    maps.insert(entry.tone_map);
  }
  EXPECT_EQ(names.size(), 4u);
  EXPECT_EQ(maps.size(), 4u);
}

TEST(ToneMap, ExposureIsInStops) {
  EXPECT_EQ(shown_grey(0.25f, ToneMap::none, 1.0f), 188);
  EXPECT_EQ(shown_grey(2.0f, ToneMap::none, -2.0f), 188);
}

TEST(ToneMap, NoneClampsEachChannel) {
  EXPECT_EQ(shown(2.0f, 0.5f, -1.0f, ToneMap::none), (Code{255, 188, 0}));
}

TEST(ToneMap, AcesMapsGreyByTheFit) {
  // The rows of both matrices add up to 1, so grey goes through the rational fit alone.
  for (const double y : {0.02, 0.18, 0.5, 1.0, 4.0}) {
    const double fit =
        (y * (y + 0.0245786) - 0.000090537) / (y * (0.983729 * y + 0.4329510) + 0.238081);
    EXPECT_EQ(shown_grey(static_cast<float>(y), ToneMap::aces), code_of(fit)) << y;
  }
  EXPECT_EQ(shown_grey(0.18f, ToneMap::aces), 91);
}

TEST(ToneMap, AgxPutsMiddleGreyAtHalf) {
  // By construction the curve passes through (20/33, 1/2) at 18 % grey; the polynomial is off by
  // 0.5 code values in the mean.
  EXPECT_NEAR(shown_grey(0.18f, ToneMap::agx), 127.5, 2.0);
  // 6.5 stops above middle grey and beyond are white.
  EXPECT_GE(shown_grey(0.18f * std::exp2(6.5f), ToneMap::agx), 254);
  EXPECT_EQ(shown_grey(1e4f, ToneMap::agx), shown_grey(0.18f * std::exp2(6.6f), ToneMap::agx));
}

TEST(ToneMap, AgxTurnsBrightSaturatedLightToWhite) {
  const Code dim = shown(0.5f, 0.0f, 0.0f, ToneMap::agx);
  const Code bright = shown(500.0f, 0.0f, 0.0f, ToneMap::agx);
  EXPECT_LT(dim[1] * 3, dim[0]);
  EXPECT_GT(bright[1] * 3, bright[0] * 2);
}

TEST(ToneMap, KhronosNeutralKeepsBaseColours) {
  // Up to a peak of 0.76 a colour loses only the Fresnel offset: 0.04 where its smallest channel is
  // 0.08 or more, x - 6.25 x² where that is x.
  EXPECT_EQ(shown(0.5f, 0.3f, 0.2f, ToneMap::khronos_neutral),
            (Code{code_of(0.46), code_of(0.26), code_of(0.16)}));
  EXPECT_EQ(shown(0.79f, 0.3f, 0.08f, ToneMap::khronos_neutral),
            (Code{code_of(0.75), code_of(0.26), code_of(0.04)}));
  EXPECT_EQ(shown(0.5f, 0.04f, 0.3f, ToneMap::khronos_neutral),
            (Code{code_of(0.47), code_of(0.01), code_of(0.27)}));
}

TEST(ToneMap, KhronosNeutralCompressesAbove) {
  // White: the peak 0.96 becomes 1 - 0.24² / (0.96 + 0.24 - 0.76).
  EXPECT_EQ(shown_grey(1.0f, ToneMap::khronos_neutral), code_of(1.0 - 0.0576 / 0.44));
  // Pure red of 2: no offset, peak 2, and green fades towards the new peak.
  const double peak = 1.0 - 0.0576 / (2.0 + 0.24 - 0.76);
  const double fade = 1.0 - 1.0 / (0.15 * (2.0 - peak) + 1.0);
  EXPECT_EQ(shown(2.0f, 0.0f, 0.0f, ToneMap::khronos_neutral),
            (Code{code_of(peak), code_of(peak * fade), code_of(peak * fade)}));
}

TEST(ToneMap, EveryCurveRisesFromBlackToNearWhite) {
  for (const ToneMapName& entry : kToneMapNames) {
    EXPECT_EQ(shown_grey(0.0f, entry.tone_map), 0) << entry.name;
    int last = 0;
    for (float ev = -14.0f; ev <= 15.0f; ev += 0.05f) {
      const int code = shown_grey(0.18f * std::exp2(ev), entry.tone_map);
      EXPECT_GE(code, last) << entry.name << " at " << ev;
      last = code;
    }
    EXPECT_GE(last, 254) << entry.name;
  }
}

TEST(ToneMap, BrokenSamplesGiveStatedValues) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const float largest = std::numeric_limits<float>::max();
  for (const ToneMapName& entry : kToneMapNames) {
    const ToneMap map = entry.tone_map;
    EXPECT_EQ(shown(nan, 0.2f, -5.0f, map), shown(0.0f, 0.2f, 0.0f, map)) << entry.name;
    EXPECT_EQ(shown(infinity, 0.2f, 0.1f, map), shown(65504.0f, 0.2f, 0.1f, map)) << entry.name;
    EXPECT_EQ(shown(largest, largest, largest, map), shown(65504.0f, 65504.0f, 65504.0f, map));
    EXPECT_EQ(shown(0.0f, 1.0f, -infinity, map, 1000.0f), shown(0.0f, 65504.0f, 0.0f, map));
  }
}

TEST(ToneMap, GreyAndCoverageChannels) {
  ImageF grey(1, 1, 1);
  grey.samples = {0.5f};
  EXPECT_EQ(to_display(grey, 0.0f, ToneMap::none).samples, (std::vector<uint8_t>{188, 188, 188}));

  ImageF covered(2, 1, 4);
  covered.samples = {0.5f, 0.5f, 0.5f, 0.5f, 0.0f, 0.0f, 0.0f, 7.0f};
  const Image8 result = to_display(covered, 0.0f, ToneMap::none);
  EXPECT_EQ(result.channels, 4u);
  EXPECT_EQ(result.samples, (std::vector<uint8_t>{188, 188, 188, 128, 0, 0, 0, 255}));
}

}  // namespace
}  // namespace lueur
