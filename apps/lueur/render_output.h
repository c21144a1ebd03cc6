// SPDX-License-Identifier: MIT
// Writes what one rendered frame brought back.
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "destination.h"
#include "frame/recorder.h"
#include "image/tone_map.h"

namespace lueur::cli {

struct Development {
  float exposure_ev = 0;
  ToneMap tone_map = ToneMap::khronos_neutral;
  float near_m = 0;                               // of the camera
  std::map<std::string, std::string> attributes;  // of EXR headers
};

// The picture: as PNG exposed, tone mapped and in sRGB; as EXR with the layers of exr_layers().
Result<void> write_pictures(const std::vector<Destination>& destinations,
                            std::span<const Pixels> pixels, const Development& development);

// One image of a pass: as PNG by view_picture(), as EXR the values as they are.
Result<void> write_view(const std::vector<Destination>& destinations, const Pixels& view,
                        const Development& development);

// Every image "pass.image" in `pixels` as `folder`/pass.image.exr, the values as they are; the
// second one of a name as pass.image.2.exr. Returns the paths.
Result<std::vector<std::string>> write_dumps(const std::filesystem::path& folder,
                                             std::span<const Pixels> pixels,
                                             const Development& development);

}  // namespace lueur::cli
