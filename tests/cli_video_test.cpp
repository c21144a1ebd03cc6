// SPDX-License-Identifier: MIT
// Videos of lueur render --frames. What stands in PATH as ffmpeg is a script of the test's own, so
// that the frames and the failures are known; the last test asks the real one where there is one.
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <string>

#include "image/png.h"
#include "support/cli.h"

namespace lueur {
namespace {

class CliVideo : public Cli {
 protected:
  void SetUp() override {
    Cli::SetUp();
    if (const char* path = std::getenv("PATH")) path_ = path;
  }
  void TearDown() override {
    ::setenv("PATH", path_.c_str(), 1);
    Cli::TearDown();
  }

  // From now on ffmpeg is this script. "$last" is the name of its last argument, the file to make.
  void put_ffmpeg(const std::string& script) {
    const fs::path bin = folder_ / "bin";
    fs::create_directories(bin);
    const std::string text =
        "#!/bin/sh\nfor last; do :; done\nlast=${last#file:}\n" + script + "\n";
    ASSERT_TRUE(write_file(bin / "ffmpeg", text).ok());
    fs::permissions(bin / "ffmpeg", fs::perms::owner_all);
    ::setenv("PATH", (bin.string() + ":" + path_).c_str(), 1);
  }
  // Writes what it is given and the arguments it is called with.
  void put_copying_ffmpeg() { put_ffmpeg("echo \"$@\" > arguments; cat > \"$last\""); }

  Arguments of(const char* frames, const Arguments& outputs) const {
    Arguments arguments = {"render", "cornell", "--size", "16x10", "--frames", frames};
    for (const std::string& output : outputs) {
      arguments.emplace_back("-o");
      arguments.push_back(output);
    }
    return arguments;
  }

  std::string path_;
};

TEST_F(CliVideo, HoldsTheFramesAsThePicturesDo) {
  put_copying_ffmpeg();
  Arguments arguments = of("3-5", {"{frame}.png", "my video.mp4"});
  arguments.insert(arguments.end(), {"--fps", "24"});
  const Ended ended = run(arguments);
  ASSERT_EQ(ended.code, 0) << ended.err;
  std::string expected;
  for (const char* name : {"3.png", "4.png", "5.png"}) {
    const auto picture = read_png(folder_ / name);
    ASSERT_TRUE(picture.ok());
    ASSERT_EQ(picture->channels, 4u);
    for (size_t i = 0; i < picture->samples.size(); ++i)
      if (i % 4 < 3) expected += static_cast<char>(picture->samples[i]);
  }
  EXPECT_EQ(expected.size(), 3u * 16 * 10 * 3);
  EXPECT_TRUE(text_of(folder_ / "my video.mp4") == expected);
  const std::string called = text_of(folder_ / "arguments");
  for (const char* part :
       {"-f rawvideo", "-pixel_format rgb24", "-video_size 16x10", "-framerate 24 ", "-f mp4"})
    EXPECT_NE(called.find(part), std::string::npos) << part << " is not in " << called;
  EXPECT_EQ(file_count(), 6u);  // three pictures, the video, bin, arguments
}

// More than a pipe holds, so that writing meets a reader that has gone.
TEST_F(CliVideo, TellsWhatFfmpegSays) {
  for (const char* script :
       {"echo first >&2; echo 'no space, it says' >&2; exit 1",
        "echo half > \"$last\"; echo 'no space, it says' >&2; cat > /dev/null; exit 1",
        "echo half > \"$last\"; echo 'no space, it says' >&2; kill -9 $$"}) {
    put_ffmpeg(script);
    ASSERT_TRUE(write_file(folder_ / "old.mp4", std::string_view("old")).ok());
    for (const char* video : {"new.webm", "old.mp4"})
      expect_error(4, of("0-9", {video}),
                   std::string(video) + ": cannot be written: ffmpeg: no space");
    EXPECT_EQ(text_of(folder_ / "old.mp4"), "old");
    EXPECT_EQ(file_count(), 2u);  // and bin
  }
  put_ffmpeg("exit 3");
  expect_error(4, of("0", {"new.mkv"}), "new.mkv");
}

TEST_F(CliVideo, UnfinishedOnesGo) {
  put_copying_ffmpeg();
  fs::create_symlink("/dev/full", folder_ / "1.png");
  expect_error(4, of("0-3", {"a.mp4", "{frame}.png"}), "1.png");
  EXPECT_FALSE(fs::exists(folder_ / "a.mp4"));
  EXPECT_EQ(file_count(), 4u);  // bin, arguments, frame 0, the link
}

TEST_F(CliVideo, InterruptedItEndsEarly) {
  put_copying_ffmpeg();
  const pid_t child = start(LUEUR_PROGRAM, of("0-50000", {"a.mp4", "{frame:5}.png"}));
  for (int k = 0; k < 1000 && !fs::exists(folder_ / "00001.png"); ++k) ::usleep(20'000);
  ASSERT_EQ(::kill(child, SIGINT), 0);
  const Ended ended = end(child);
  EXPECT_EQ(ended.code, 130) << ended.err;
  const size_t frames = file_count() - 3;  // bin, arguments, the video
  EXPECT_NE(ended.err.find(" " + std::to_string(frames) + " of 50001"), std::string::npos)
      << ended.err;
  EXPECT_EQ(fs::file_size(folder_ / "a.mp4"), frames * 16 * 10 * 3);
}

TEST_F(CliVideo, Refused) {
  put_copying_ffmpeg();
  fs::create_symlink("/dev/null", folder_ / "device.mp4");
  expect_error(2, {"render", "cornell", "-o", "a.mp4"}, "--frames");
  expect_error(2, of("0-1", {"a{frame}.mp4"}), "{frame}");
  expect_error(2, of("0-1", {"a.mp4", "a.mp4"}), "twice");
  Arguments odd = of("0-1", {"a.mp4"});
  odd.insert(odd.end(), {"--view", "hierarchical.gather@0.indirect"});
  expect_error(2, odd, "8x5");
  expect_error(2, {"render", "cornell", "--size", "15x10", "--frames", "0", "-o", "a.mp4"}, "even");
  expect_error(4, of("0-1", {"missing/a.mp4"}), "missing");
  expect_error(4, of("0-1", {"device.mp4"}), "regular");
  ::setenv("PATH", "/nowhere", 1);
  expect_error(4, of("0-1", {"a.mp4"}), "install it");
  EXPECT_EQ(file_count(), 2u);  // bin and the link
}

TEST_F(CliVideo, OfTheRealFfmpeg) {
  if (run_other("ffmpeg", {"-version"}).code != 0) GTEST_SKIP() << "no ffmpeg here";
  for (const char* video : {"a.mp4", "a.webm", "a.mkv"}) {
    const Ended ended = run(of("0-4", {video}));
    ASSERT_EQ(ended.code, 0) << ended.err;
    ASSERT_EQ(run_other("ffmpeg", {"-loglevel", "error", "-i", video, "-start_number", "0",
                                   std::string(video) + ".%d.png"})
                  .code,
              0);
    for (int frame = 0; frame < 5; ++frame) {
      const auto picture =
          read_png(folder_ / (std::string(video) + "." + std::to_string(frame) + ".png"));
      ASSERT_TRUE(picture.ok()) << video << " " << frame;
      EXPECT_EQ(picture->width, 16u);
    }
    EXPECT_FALSE(fs::exists(folder_ / (std::string(video) + ".5.png")));
  }
}

}  // namespace
}  // namespace lueur
