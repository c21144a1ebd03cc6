// SPDX-License-Identifier: MIT
// Frames of an animation by their numbers, and the files they go to: "pictures/{frame:4}.png" is
// pictures/0012.png for frame 12, and a video holds them all.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lueur/image.h"
#include "lueur/result.h"

namespace lueur::cli {

struct FrameRange {
  uint32_t first = 0;
  uint32_t last = 0;  // not before the first
  uint32_t count() const { return last - first + 1; }
};

// "A-B" or "A", whole numbers from 0 to 999999.
Result<FrameRange> parse_frames(const std::string& text);

// Whether a frame's number has a place in the name.
bool has_frame(const std::string& name);
// `name` with the number in its places. {frame:N} has N digits or more, with leading zeros.
std::string name_of_frame(const std::string& name, uint32_t frame);

// Whether the path's ending is one of a video: .mp4, .webm or .mkv.
bool is_video(const std::filesystem::path& path);

struct FrameOutputs {
  std::vector<std::string> pictures;  // each with a place for the number
  std::vector<std::filesystem::path> videos;
};

// The names of -o with --frames. Fails like check_destinations(), with ErrorKind::usage also on a
// picture without a place for the number or with one in its folder, a video with one or of an odd
// size, and two frames of one name; with ErrorKind::output on videos without ffmpeg.
Result<FrameOutputs> check_frame_outputs(const std::vector<std::string>& names, FrameRange frames,
                                         Extent size);
// The same without --frames: that no name needs it.
Result<void> check_no_frames(const std::vector<std::string>& names);

}  // namespace lueur::cli
