// SPDX-License-Identifier: MIT
// Videos, encoded by the program ffmpeg where there is one: it gets the frames through a pipe.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "base/file.h"
#include "image/image.h"
#include "lueur/image.h"

namespace lueur::cli {

// ffmpeg's name of the container with this ending: .mp4, .webm or .mkv; "" for all others.
std::string_view muxer_of(const std::filesystem::path& path);

// Players know colours at half the resolution alone: width and height have to be even.
Result<void> check_video_size(const std::filesystem::path& path, Extent size);

// Where PATH has ffmpeg. The error (ErrorKind::output) names `video`, for which it is looked for.
Result<std::filesystem::path> find_ffmpeg(const std::filesystem::path& video);

// One video on its way. Its file appears when finish() succeeds, and not at all otherwise.
class VideoFile {
 public:
  // Starts ffmpeg: H.264 for .mp4 and .mkv, VP9 for .webm.
  static Result<std::unique_ptr<VideoFile>> open(const std::filesystem::path& path, Extent size,
                                                 float rate);
  ~VideoFile();
  VideoFile(const VideoFile&) = delete;
  VideoFile& operator=(const VideoFile&) = delete;

  // A frame of 3 channels and the video's size. The error is ffmpeg's own last line.
  Result<void> add(const Image8& frame);
  Result<void> finish();

 private:
  VideoFile(std::filesystem::path path, PendingFile file)
      : path_(std::move(path)), file_(std::move(file)) {}
  Result<void> start(const std::filesystem::path& ffmpeg, Extent size, float rate);
  // Closes the pipe, waits for ffmpeg, and tells whether all went well.
  bool end();
  Error failure() const;

  std::filesystem::path path_;
  PendingFile file_;
  pid_t ffmpeg_ = -1;  // -1: it has ended
  int frames_ = -1;    // the pipe's end for writing
  int messages_ = -1;  // a file in memory with what ffmpeg says
};

}  // namespace lueur::cli
