// SPDX-License-Identifier: MIT
#include "base/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <system_error>
#include <utility>

#include "base/try.h"

namespace lueur {
namespace fs = std::filesystem;
namespace {

Error cannot_write(const fs::path& path, int error_number) {
  return {ErrorKind::output, path.string() + ": cannot be written: " + std::strerror(error_number)};
}

std::span<const uint8_t> as_bytes(std::string_view text) {
  return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

Result<void> write_in_place(const fs::path& path, std::span<const uint8_t> bytes) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) return cannot_write(path, errno);
  const int write_error = write_all(descriptor, bytes);
  const int close_error = ::close(descriptor) != 0 ? errno : 0;
  if (write_error != 0) return cannot_write(path, write_error);
  if (close_error != 0) return cannot_write(path, close_error);
  return {};
}

// Of a regular file; anything else could block, or have no end.
Result<uint64_t> size_of_file(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found)
    return Error{ErrorKind::input, path.string() + ": no such file"};
  if (error) return Error{ErrorKind::input, path.string() + ": " + error.message()};
  if (!fs::is_regular_file(status))
    return Error{ErrorKind::input, path.string() + ": not a regular file"};
  const uint64_t size = fs::file_size(path, error);
  if (error) return Error{ErrorKind::input, path.string() + ": " + error.message()};
  return size;
}

Result<std::vector<uint8_t>> read_start(const fs::path& path, uint64_t size) {
  std::ifstream file(path, std::ios::binary);
  std::vector<uint8_t> bytes(size);
  if (!file ||
      !file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size)))
    return Error{ErrorKind::input, path.string() + ": cannot be read: " + std::strerror(errno)};
  return bytes;
}

}  // namespace

Result<std::vector<uint8_t>> read_file(const fs::path& path, uint64_t max_bytes) {
  LUEUR_TRY(size, size_of_file(path));
  if (size > max_bytes)
    return Error{ErrorKind::input, path.string() + ": " + std::to_string(size) +
                                       " bytes, more than the limit of " +
                                       std::to_string(max_bytes)};
  return read_start(path, size);
}

Result<std::vector<uint8_t>> read_file_head(const fs::path& path, uint64_t max_bytes) {
  LUEUR_TRY(size, size_of_file(path));
  return read_start(path, std::min(size, max_bytes));
}

int write_all(int descriptor, std::span<const uint8_t> bytes) {
  size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t n = ::write(descriptor, bytes.data() + done, bytes.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return n == 0 ? EIO : errno;
    done += static_cast<size_t>(n);
  }
  return 0;
}

int write_all(int descriptor, std::string_view text) {
  return write_all(descriptor, as_bytes(text));
}

Result<void> write_file(const fs::path& path, std::span<const uint8_t> bytes) {
  // Write devices and pipes in place: they cannot be replaced by a rename.
  struct stat status {};
  if (::stat(path.c_str(), &status) == 0) {
    if (S_ISDIR(status.st_mode)) return cannot_write(path, EISDIR);
    if (!S_ISREG(status.st_mode)) return write_in_place(path, bytes);
  }

  LUEUR_TRY(file, PendingFile::create(path));
  if (const int failure = write_all(file.descriptor(), bytes); failure != 0)
    return cannot_write(path, failure);
  return file.commit();
}

Result<void> write_file(const fs::path& path, std::string_view text) {
  return write_file(path, as_bytes(text));
}

Result<PendingFile> PendingFile::create(const fs::path& path) {
  // Write beside the final name, so that the rename stays on one file system.
  std::string temporary = path.string() + ".tmp-XXXXXX";
  const int descriptor = ::mkostemp(temporary.data(), O_CLOEXEC);
  if (descriptor < 0) return cannot_write(path, errno);
  PendingFile file(path, temporary, descriptor);

  // mkostemp makes it private.
  const mode_t mask = ::umask(0);
  ::umask(mask);
  if (::fchmod(descriptor, 0666 & ~mask) != 0) return cannot_write(path, errno);
  return file;
}

PendingFile::PendingFile(fs::path path, fs::path temporary, int descriptor)
    : path_(std::move(path)), temporary_(std::move(temporary)), descriptor_(descriptor) {}

PendingFile::PendingFile(PendingFile&& other) noexcept
    : path_(std::move(other.path_)),
      temporary_(std::move(other.temporary_)),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

PendingFile::~PendingFile() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  ::unlink(temporary_.c_str());
}

Result<void> PendingFile::commit() {
  int failure = ::fsync(descriptor_) != 0 ? errno : 0;
  if (::close(std::exchange(descriptor_, -1)) != 0 && failure == 0) failure = errno;
  if (failure == 0 && ::rename(temporary_.c_str(), path_.c_str()) != 0) failure = errno;
  if (failure == 0) return {};
  ::unlink(temporary_.c_str());
  return cannot_write(path_, failure);
}

fs::path cache_folder() {
  if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && *cache == '/')
    return fs::path(cache) / "lueur";
  if (const char* home = std::getenv("HOME"); home && *home == '/')
    return fs::path(home) / ".cache" / "lueur";
  return {};
}

}  // namespace lueur
