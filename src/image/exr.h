// SPDX-License-Identifier: MIT
// OpenEXR files: linear samples with their full range, one named layer for each thing that was
// rendered. Colours are Rec.709, the default of the format.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "image/image.h"
#include "lueur/result.h"

namespace lueur {

inline constexpr uint32_t kMaxExrSide = 16384;                 // pixels
inline constexpr uint32_t kMaxExrChannels = 128;               // of all layers together
inline constexpr uint64_t kMaxExrSamples = uint64_t{1} << 28;  // 1 GiB of floats

struct ExrOptions {
  // Layers kept as 32-bit floats; all others become half floats. Finite values beyond the range of
  // a half float are written as its largest, ±65504; NaN and infinities stay what they are.
  std::set<std::string> float_layers = {"depth"};

  // String attributes of the header, e.g. {"lueur.scene", "cornell"}.
  std::map<std::string, std::string> attributes;
};

// Writes the layers, which have one size and different names, as one scan-line part with ZIP
// compression; see ImageLayer for the names of the channels. All or nothing. The same layers give
// the same bytes. Fails (ErrorKind::output) like write_file, and for pictures beyond the limits.
Result<void> write_exr(const std::filesystem::path& path, std::span<const ImageLayer> layers,
                       const ExrOptions& options = {});

// Reads the layers of a scan-line file: the main picture first, if there is one, then by name. The
// channels of a layer come in the order R G B A, X Y Z, numbers, then all others by name. Fails
// (ErrorKind::input) on a damaged file, one beyond the limits above, a deep, tiled or multi-part
// one, one with subsampled channels, and one compressed with B44 or DWA. The header is checked
// before memory is taken for pixels. The format has checksums only in its ZIP compressions: damage
// elsewhere may show as wrong samples, never as more. `name` stands for the file in messages.
// The header's string attributes go into `attributes`, where one is given.
using ExrAttributes = std::map<std::string, std::string>;
Result<std::vector<ImageLayer>> decode_exr(std::span<const uint8_t> bytes, const std::string& name,
                                           ExrAttributes* attributes = nullptr);
Result<std::vector<ImageLayer>> read_exr(const std::filesystem::path& path,
                                         ExrAttributes* attributes = nullptr);

}  // namespace lueur
