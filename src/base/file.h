// SPDX-License-Identifier: MIT
// Files as the whole house reads and writes them: reads are capped, writes are all or nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "lueur/result.h"

namespace lueur {

// Reads a whole regular file. Fails (ErrorKind::input) on a missing file, a folder or device, an
// unreadable file, or one of more than `max_bytes`.
Result<std::vector<uint8_t>> read_file(const std::filesystem::path& path, uint64_t max_bytes);

// The same for its first bytes alone, `max_bytes` at most, however large the file.
Result<std::vector<uint8_t>> read_file_head(const std::filesystem::path& path, uint64_t max_bytes);

// Writes `bytes` under a temporary name in the same folder, flushes them to the disk and renames
// the file to `path`, so that `path` holds either its old content or all of the new one. A path
// that exists and is not a regular file (a pipe, /dev/stdout, /dev/full) is written in place. Fails
// (ErrorKind::output) when the folder is missing, not writable, or the disk is full; the temporary
// file is removed then.
Result<void> write_file(const std::filesystem::path& path, std::span<const uint8_t> bytes);
Result<void> write_file(const std::filesystem::path& path, std::string_view text);

// Writes everything to the descriptor, however many calls that takes; returns 0 or errno.
int write_all(int descriptor, std::span<const uint8_t> bytes);
int write_all(int descriptor, std::string_view text);

// A file on its way: it has a temporary name in the folder of `path`, and the permissions that a
// plain open() would have given it, until commit() flushes it to the disk and renames it. Without
// that it is removed.
class PendingFile {
 public:
  // Fails (ErrorKind::output) when the folder is missing, not writable, or the disk is full.
  static Result<PendingFile> create(const std::filesystem::path& path);
  ~PendingFile();
  PendingFile(PendingFile&& other) noexcept;
  PendingFile& operator=(PendingFile&&) = delete;

  // Empty at first; to be written through either, not replaced.
  const std::filesystem::path& temporary() const { return temporary_; }
  int descriptor() const { return descriptor_; }
  // Fails (ErrorKind::output) when the disk is full; the file is removed then.
  Result<void> commit();

 private:
  PendingFile(std::filesystem::path path, std::filesystem::path temporary, int descriptor);
  std::filesystem::path path_;
  std::filesystem::path temporary_;
  int descriptor_ = -1;  // -1: nothing is left to remove
};

// The folder for data that may be deleted at any time: $XDG_CACHE_HOME/lueur, or ~/.cache/lueur.
// Empty when neither variable is set; the caller then keeps no cache.
std::filesystem::path cache_folder();

}  // namespace lueur
