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

// The folder for data that may be deleted at any time: $XDG_CACHE_HOME/lueur, or ~/.cache/lueur.
// Empty when neither variable is set; the caller then keeps no cache.
std::filesystem::path cache_folder();

}  // namespace lueur
