// SPDX-License-Identifier: MIT
// Localized cube maps: light from a handful of texels.
//
// L. Szirmay-Kalos, I. Lazányi: "Indirect Diffuse and Glossy Illumination on the GPU", SCCG 2006
// (LCM).
//
// A map shows what surrounds an object, without it: the mean radiance L_i of what is seen through
// each of 6 M^2 texels, and its mean distance d_i. A point x of the object gets
//
//   L(x -> w) = sum over texels i of  L_i f(w_i, w) cos+(theta_i) dw*_i,
//
//   dw*_i = d_i^2 dw_i / (|x - y_i|^2 (1 - dw_i / pi) + d_i^2 dw_i / pi),
//
// LCM (3) and 4, where y_i lies d_i from the map's centre through the middle of the texel, dw_i is
// the texel's solid angle from there, and w_i the direction from x to y_i. What lies between x and
// y_i is not asked for.
//
// Objects are those of Host::objects(), each with a map around its centre; near ones share one. A
// pixel of an object takes its map (GBuffer::object). All other pixels take scene probes, maps of
// all that is drawn at the middles of a grid of cells over Host::bounds(), interpolated linearly
// between those middles.
//
// What a map shows is captured again, a few faces a frame, when a light or an object has changed.
#pragma once

#include <memory>

#include "lueur/technique.h"

namespace lueur {

struct CubeMapSettings {
  enum class Side : int32_t { of_2, of_4, of_8, of_16, of_32, of_64, of_128, of_256 };
  enum class Picture : int32_t { of_64, of_128, of_256, of_512 };
  enum class Centre : int32_t { object, scene };
  enum class Method : int32_t { localized, classical };

  Side side = Side::of_4;             // M, texels; not above `picture`
  Picture picture = Picture::of_256;  // of a face, pixels
  Method method = Method::localized;
  bool glossy = false;
  float blinn_exponent = 0.0f;
  Centre centre = Centre::object;
  int32_t most_maps = 16;
  float share = 2.0f;
  int32_t probes = 1;
  int32_t faces_a_frame = 6;
  float move_threshold = 0.02f;
};

// Outputs: `diffuse`, and `specular` with Settings::glossy. The alpha of each is 1 where a map of
// an object was used, 0 where scene probes were.
//
// Needs a host that renders views; objects and a background are optional. Of the camera: view,
// depth, normal, `object` if there are any, and reflectance and lobes for glossy. render() fails
// the frame (ErrorKind::usage) where one of them is missing, and where the device has no image that
// is high enough for all maps.
//
// Memory: 192 M^2 bytes a map, kept between frames, and 24 bytes a pixel while it renders, 32 with
// glossy.
class CubeMap final : public Technique {
 public:
  explicit CubeMap(CubeMapSettings settings = {});
  ~CubeMap() override;
  Outputs render(Frame& frame, const Inputs& inputs) override;
  void* settings() override { return &settings_; }

  static std::span<const SettingInfo> settings_table();

 private:
  struct Memory;
  CubeMapSettings settings_;
  std::unique_ptr<Memory> memory_;
};

}  // namespace lueur
