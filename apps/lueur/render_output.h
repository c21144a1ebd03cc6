// SPDX-License-Identifier: MIT
// Writes what one rendered frame brought back.
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "destination.h"
#include "frame/recorder.h"
#include "image/tone_map.h"
#include "session.h"

namespace lueur::cli {

struct Development {
  float exposure_ev = 0;
  ToneMap tone_map = ToneMap::khronos_neutral;
  float near_m = 0;                               // of the camera
  std::string_view diffuse_alpha;                 // of the technique, see exr_layers()
  std::map<std::string, std::string> attributes;  // of EXR headers
};

// The picture: as PNG exposed, tone mapped and in sRGB; as EXR with the layers of exr_layers().
Result<void> write_pictures(const std::vector<Destination>& destinations,
                            std::span<const Pixels> pixels, const Development& development);

// What a frame is asked to show: its picture, written as above, or where `view` names an image
// "pass.image" that one: as PNG by view_picture(), as EXR the values as they are. Fails with
// ErrorKind::usage when the frame has no such image, or one that cannot be shown.
Result<void> write_frame(const std::string& view, const std::vector<Destination>& destinations,
                         const FrameRecord& frame, const Development& development);
// The same as PNG would hold it.
Result<Image8> shown(const std::string& view, const FrameRecord& frame,
                     const Development& development);

// Every image "pass.image" in `pixels` as `folder`/pass.image.exr, the values as they are; the
// second one of a name as pass.image.2.exr. Returns the paths.
Result<std::vector<std::string>> write_dumps(const std::filesystem::path& folder,
                                             std::span<const Pixels> pixels,
                                             const Development& development);

}  // namespace lueur::cli
