// SPDX-License-Identifier: MIT
#include "video.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <vector>

#include "base/check.h"
#include "base/try.h"
#include "destination.h"

namespace lueur::cli {
namespace fs = std::filesystem;
namespace {

struct Container {
  std::string_view ending;
  std::string_view muxer;
  std::vector<std::string> encoder;
};

// Qualities at which the noise of a frame stays visible, as this is what videos are looked at for.
const std::array<Container, 3>& containers() {
  const std::vector<std::string> h264 = {"-c:v", "libx264", "-crf", "16"};
  const std::vector<std::string> vp9 = {"-c:v", "libvpx-vp9", "-crf", "20", "-b:v", "0"};
  static const std::array<Container, 3> kContainers = {
      {{".mp4", "mp4", h264}, {".webm", "webm", vp9}, {".mkv", "matroska", h264}}};
  return kContainers;
}

const Container* container_of(const fs::path& path) {
  const std::string ending = ending_of(path);
  for (const Container& container : containers())
    if (container.ending == ending) return &container;
  return nullptr;
}

std::vector<std::string> arguments_for(const Container& container, const fs::path& file,
                                       Extent size, float rate) {
  const std::string size_px = std::to_string(size.width) + "x" + std::to_string(size.height);
  char frames_a_second[32];
  std::snprintf(frames_a_second, sizeof(frames_a_second), "%.9g", static_cast<double>(rate));
  std::vector<std::string> all = {"ffmpeg", "-hide_banner", "-loglevel",     "error", "-nostdin",
                                  "-f",     "rawvideo",     "-pixel_format", "rgb24", "-video_size",
                                  size_px,  "-framerate",   frames_a_second, "-i",    "pipe:0"};
  all.insert(all.end(), container.encoder.begin(), container.encoder.end());
  // Say which matrix the colours went through: players guess it from the size otherwise.
  for (const char* argument :
       {"-vf", "scale=out_color_matrix=bt709:out_range=tv", "-pix_fmt", "yuv420p", "-colorspace",
        "bt709", "-color_primaries", "bt709", "-color_trc", "iec61966-2-1", "-color_range", "tv"})
    all.emplace_back(argument);
  all.insert(all.end(), {"-f", std::string(container.muxer), "-y", "file:" + file.string()});
  return all;
}

// Starts the program with these as its standard streams; the last one takes stdout and stderr. It
// is out of reach of the terminal's Ctrl-C, which is a wish to us: what it got becomes a video.
int spawn(const fs::path& program, const std::vector<std::string>& arguments, int in, int out,
          pid_t& child) {
  std::vector<char*> argv;
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  posix_spawn_file_actions_t streams;
  posix_spawn_file_actions_init(&streams);
  posix_spawn_file_actions_adddup2(&streams, in, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&streams, out, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&streams, out, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t signals;
  sigemptyset(&signals);
  posix_spawnattr_setsigmask(&attributes, &signals);
  sigaddset(&signals, SIGPIPE);
  posix_spawnattr_setsigdefault(&attributes, &signals);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes,
                           POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  const int error =
      ::posix_spawn(&child, program.c_str(), &streams, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&streams);
  return error;
}

// The last line that says something in the last 4 KiB of a file.
std::string last_line(int descriptor) {
  std::array<char, 4096> text{};
  const off_t size = ::lseek(descriptor, 0, SEEK_END);
  const off_t from = std::max<off_t>(0, size - static_cast<off_t>(text.size()));
  const ssize_t length = ::pread(descriptor, text.data(), text.size(), from);
  std::istringstream lines(
      std::string(text.data(), static_cast<size_t>(std::max<ssize_t>(0, length))));
  std::string last;
  for (std::string line; std::getline(lines, line);)
    if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
  return last;
}

}  // namespace

std::string_view muxer_of(const fs::path& path) {
  const Container* container = container_of(path);
  return container ? container->muxer : std::string_view();
}

Result<void> check_video_size(const fs::path& path, Extent size) {
  if (size.width % 2 == 0 && size.height % 2 == 0) return {};
  return Error{ErrorKind::usage, "-o '" + path.string() + "': " + std::to_string(size.width) + "x" +
                                     std::to_string(size.height) +
                                     " pixels; a video needs an even width and height"};
}

Result<fs::path> find_ffmpeg(const fs::path& video) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path program = fs::path(folder) / "ffmpeg";
    std::error_code error;
    if (fs::is_regular_file(program, error) && ::access(program.c_str(), X_OK) == 0) return program;
  }
  return Error{ErrorKind::output, video.string() +
                                      ": cannot be written: PATH has no ffmpeg; install it, or "
                                      "write pictures with {frame} in their names"};
}

Result<std::unique_ptr<VideoFile>> VideoFile::open(const fs::path& path, Extent size, float rate) {
  LUEUR_TRY_VOID(check_video_size(path, size));
  LUEUR_TRY(ffmpeg, find_ffmpeg(path));
  LUEUR_TRY(file, PendingFile::create(path));
  std::unique_ptr<VideoFile> video(new VideoFile(path, std::move(file)));
  LUEUR_TRY_VOID(video->start(ffmpeg, size, rate));
  return video;
}

Result<void> VideoFile::start(const fs::path& ffmpeg, Extent size, float rate) {
  const Container* container = container_of(path_);
  LUEUR_CHECK(container);
  int pipe[2] = {-1, -1};
  messages_ = ::memfd_create("ffmpeg messages", MFD_CLOEXEC);
  int error = messages_ < 0 || ::pipe2(pipe, O_CLOEXEC) != 0 ? errno : 0;
  if (error == 0) {
    frames_ = pipe[1];
    error = spawn(ffmpeg, arguments_for(*container, file_.temporary(), size, rate), pipe[0],
                  messages_, ffmpeg_);
    ::close(pipe[0]);
  }
  if (error == 0) return {};
  ffmpeg_ = -1;
  return Error{ErrorKind::output, path_.string() + ": cannot be written: " + ffmpeg.string() +
                                      ": " + std::strerror(error)};
}

VideoFile::~VideoFile() {
  // What it made so far is not wanted.
  if (ffmpeg_ > 0) ::kill(ffmpeg_, SIGKILL);
  end();
  if (messages_ >= 0) ::close(messages_);
}

Result<void> VideoFile::add(const Image8& frame) {
  LUEUR_CHECK_OP(frame.channels, ==, 3u);
  if (write_all(frames_, frame.samples) == 0) return {};
  end();
  return failure();
}

Result<void> VideoFile::finish() {
  if (!end()) return failure();
  return file_.commit();
}

bool VideoFile::end() {
  if (frames_ >= 0) ::close(std::exchange(frames_, -1));
  if (ffmpeg_ < 0) return false;
  int status = 0;
  while (::waitpid(ffmpeg_, &status, 0) < 0 && errno == EINTR) continue;
  ffmpeg_ = -1;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

Error VideoFile::failure() const {
  const std::string line = last_line(messages_);
  return {ErrorKind::output, path_.string() + ": cannot be written: ffmpeg: " +
                                 (line.empty() ? "ended early without a word" : line)};
}

}  // namespace lueur::cli
