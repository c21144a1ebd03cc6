// SPDX-License-Identifier: MIT
// The passes of one frame of the technique.
#pragma once

#include <glm/glm.hpp>

#include "cube_maps/texel_lights.h"
#include "frame/recorder.h"
#include "lueur/cube_map.h"
#include "techniques/cube_map/maps.h"
#include "techniques/cube_map/params.h"

namespace lueur::cube_map {

inline uint32_t side_of(CubeMapSettings::Side side) {
  return 2u << static_cast<uint32_t>(side);
}

inline uint32_t pixels_of(CubeMapSettings::Picture picture) {
  return 64u << static_cast<uint32_t>(picture);
}

class CubeMapFrame {
 public:
  CubeMapFrame(Frame& frame, const CubeMapSettings& settings, const Inputs& inputs, Maps& maps);

  // Which maps there are, and what they show of the world as it is.
  void capture();
  // E / pi, or what the glossy lobes reflect.
  Image gather(bool glossy);

 private:
  // An image that all maps share, one below the other, and that lasts. Gives whether it held the
  // frame before, which is then in it.
  bool keep(const char* name, Extent of_a_map, Format format, Image& image);
  bool is_classical() const { return settings_.method == CubeMapSettings::Method::classical; }
  void convolve(uint32_t map);
  void upload();
  MapShare share_of(uint32_t map) const;
  void gather_from(uint32_t map, Image sum, bool glossy);
  void dispatch_gather(const GatherParams& params, Image sum, bool glossy);

  Frame& public_frame_;
  Recorder& frame_;
  const CubeMapSettings& settings_;
  const Inputs& inputs_;
  Maps& maps_;
  Extent extent_;
  glm::mat4 camera_from_world_;
  CameraParams camera_;
  CubeAtlas atlas_;
  bool has_objects_;
  Image object_;       // some image where there are none
  Image panoramas_{};  // of classical maps: panorama.glsl
  BufferRef map_of_object_{}, lobes_{};
  BufferRef texels_{};  // of one map
};

}  // namespace lueur::cube_map
