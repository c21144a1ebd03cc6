// SPDX-License-Identifier: MIT
#include "frame_names.h"

#include <algorithm>
#include <set>

#include "arguments.h"
#include "base/try.h"
#include "destination.h"
#include "video.h"

namespace lueur::cli {
namespace fs = std::filesystem;
namespace {

constexpr uint32_t kLastFrame = 999'999;
constexpr std::string_view kPlace = "{frame";

// One place of the number: "{frame}" or "{frame:N}" with N from 1 to 9.
struct Place {
  size_t begin = 0;
  size_t length = 0;  // 0: there is none
  size_t digits = 1;
};

Place next_place(std::string_view name, size_t from) {
  for (size_t at = name.find(kPlace, from); at != std::string_view::npos;
       at = name.find(kPlace, at + 1)) {
    const std::string_view rest = name.substr(at + kPlace.size());
    if (rest.starts_with('}')) return {at, kPlace.size() + 1, 1};
    if (rest.size() >= 3 && rest[0] == ':' && rest[1] >= '1' && rest[1] <= '9' && rest[2] == '}')
      return {at, kPlace.size() + 3, static_cast<size_t>(rest[1] - '0')};
  }
  return {};
}

Error wrong_name(const std::string& name, const std::string& what) {
  return {ErrorKind::usage, "-o '" + name + "': " + what};
}

// "a/b.png" -> "a/b.{frame:4}.png"
std::string with_frame(const fs::path& path) {
  fs::path name = path;
  return name.replace_extension(".{frame:4}" + path.extension().string()).string();
}

Result<void> check_video(const std::string& name, Extent size) {
  if (has_frame(name)) return wrong_name(name, "a video holds all frames; leave {frame} out");
  LUEUR_TRY_VOID(check_video_size(name, size));
  LUEUR_TRY_VOID(check_writable(name));
  std::error_code error;
  if (fs::exists(name, error) && !fs::is_regular_file(name, error))
    return Error{ErrorKind::output,
                 name + ": cannot be written: not a regular file, which a video has to be"};
  LUEUR_TRY(ffmpeg, find_ffmpeg(name));
  static_cast<void>(ffmpeg);
  return {};
}

// That no two frames have one name: frame 11 of "{frame}.png" is frame 1 of "1{frame}.png".
Result<void> check_distinct(const std::vector<std::string>& pictures, FrameRange frames) {
  if (pictures.size() < 2) return {};
  std::set<std::string> names;
  for (const std::string& picture : pictures)
    for (uint32_t frame = frames.first; frame <= frames.last; ++frame)
      if (const std::string name = name_of_frame(picture, frame); !names.insert(name).second)
        return wrong_name(picture, "frame " + std::to_string(frame) + " has the name " + name +
                                       " of another; choose names that differ");
  return {};
}

}  // namespace

Result<FrameRange> parse_frames(const std::string& text) {
  const size_t dash = text.find('-');
  const auto first = parse_count("--frames", text.substr(0, dash), 0, kLastFrame);
  const auto last = dash == std::string::npos
                        ? first
                        : parse_count("--frames", text.substr(dash + 1), 0, kLastFrame);
  if (!first.ok() || !last.ok() || *last < *first)
    return Error{ErrorKind::usage, "--frames '" + text +
                                       "': expected A-B or A, whole numbers from 0 to " +
                                       std::to_string(kLastFrame) + ", B not below A"};
  return FrameRange{*first, *last};
}

bool has_frame(const std::string& name) {
  return next_place(name, 0).length > 0;
}

std::string name_of_frame(const std::string& name, uint32_t frame) {
  const std::string number = std::to_string(frame);
  std::string text;
  size_t done = 0;
  for (Place place = next_place(name, 0); place.length > 0; place = next_place(name, done)) {
    text += name.substr(done, place.begin - done);
    text += std::string(place.digits - std::min(place.digits, number.size()), '0') + number;
    done = place.begin + place.length;
  }
  return text + name.substr(done);
}

bool is_video(const fs::path& path) {
  return !muxer_of(path).empty();
}

Result<FrameOutputs> check_frame_outputs(const std::vector<std::string>& names, FrameRange frames,
                                         Extent size) {
  FrameOutputs outputs;
  std::vector<std::string> first_frame;
  for (const std::string& name : names) {
    if (is_video(name)) {
      LUEUR_TRY_VOID(check_video(name, size));
      if (std::find(outputs.videos.begin(), outputs.videos.end(), name) != outputs.videos.end())
        return wrong_name(name, "is given twice; give it once");
      outputs.videos.emplace_back(name);
      continue;
    }
    if (!has_frame(name))
      return wrong_name(
          name,
          "each frame needs a name of its own; write {frame} or {frame:N}, N from 1 to 9, as "
          "in " +
              with_frame(name));
    if (has_frame(fs::path(name).parent_path().string()))
      return wrong_name(name, "a frame's number belongs into the file's name, not its folder's");
    outputs.pictures.push_back(name);
    first_frame.push_back(name_of_frame(name, frames.first));
  }
  LUEUR_TRY_VOID(check_distinct(outputs.pictures, frames));
  LUEUR_TRY(checked, check_destinations(first_frame, size));
  static_cast<void>(checked);
  return outputs;
}

Result<void> check_no_frames(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (is_video(name)) return wrong_name(name, "a video needs frames; add --frames A-B");
    if (name.find(kPlace) != std::string::npos)
      return wrong_name(name, "{frame} is the number of a frame; add --frames A-B");
  }
  return {};
}

}  // namespace lueur::cli
