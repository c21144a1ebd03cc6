// SPDX-License-Identifier: MIT
// Renderings of the reference as files, and those that are done kept by what they show.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "reference/reference.h"

namespace lueur::reference {

// An EXR file with all layers as 32-bit floats; its header has `attributes` and, as
// lueur.reference.*, the progress. All or nothing. The state is not in it.
Result<void> write_rendering(const std::filesystem::path& path, const Rendering& rendering,
                             const std::map<std::string, std::string>& attributes = {});
// What write_rendering() wrote. Fails (ErrorKind::input) on any other file.
Result<Rendering> read_rendering(const std::filesystem::path& path);

// As render(), but a finished rendering of the same content is taken from the cache,
// cache_folder()/references, and a new one is put there. Without a cache folder, or when it cannot
// be written, it renders all the same; `cache_note` then says why in one line.
struct CachedRendering {
  Rendering rendering;
  bool from_cache = false;
  std::string cache_note;
};
enum class Cache : uint8_t { use, ignore };  // ignore: render() alone
Result<CachedRendering> render_cached(const Scene& scene, const Shot& shot,
                                      const Settings& settings, const Control& control = {},
                                      std::span<const uint8_t> resume_from = {},
                                      Cache cache = Cache::use);

}  // namespace lueur::reference
