// SPDX-License-Identifier: MIT
#include "reference/rendering_file.h"

#include <charconv>
#include <system_error>

#include "base/file.h"
#include "base/try.h"
#include "image/exr.h"
#include "reference/content.h"

namespace lueur::reference {
namespace {

namespace fs = std::filesystem;

template <class T>
std::string text_of(T value) {
  char digits[64];
  const auto [end, error] = std::to_chars(digits, digits + sizeof(digits), value);
  return {digits, error == std::errc() ? end : digits};
}

template <class T>
bool read_value(const ExrAttributes& attributes, const char* name, T& value) {
  const auto found = attributes.find(name);
  if (found == attributes.end()) return false;
  const char* end = found->second.data() + found->second.size();
  const auto [stop, error] = std::from_chars(found->second.data(), end, value);
  return error == std::errc() && stop == end;
}

constexpr char kSppDone[] = "lueur.reference.spp";
constexpr char kSppTotal[] = "lueur.reference.spp_asked";
constexpr char kError[] = "lueur.reference.relative_error";
constexpr char kSeconds[] = "lueur.reference.seconds";
constexpr char kRays[] = "lueur.reference.rays";
constexpr char kComplete[] = "lueur.reference.complete";

}  // namespace

Result<void> write_rendering(const fs::path& path, const Rendering& rendering,
                             const std::map<std::string, std::string>& attributes) {
  ExrOptions options{.float_layers = {}, .attributes = attributes};
  for (const ImageLayer& layer : rendering.layers) options.float_layers.insert(layer.name);
  const Progress& p = rendering.progress;
  options.attributes[kSppDone] = text_of(p.spp_done);
  options.attributes[kSppTotal] = text_of(p.spp_total);
  options.attributes[kError] = text_of(p.relative_error);
  options.attributes[kSeconds] = text_of(p.seconds);
  options.attributes[kRays] = text_of(p.rays);
  options.attributes[kComplete] = rendering.complete ? "1" : "0";
  return write_exr(path, rendering.layers, options);
}

Result<Rendering> read_rendering(const fs::path& path) {
  ExrAttributes attributes;
  LUEUR_TRY(layers, read_exr(path, &attributes));
  Rendering rendering;
  Progress& p = rendering.progress;
  int complete = 0;
  if (!read_value(attributes, kSppDone, p.spp_done) ||
      !read_value(attributes, kSppTotal, p.spp_total) ||
      !read_value(attributes, kError, p.relative_error) ||
      !read_value(attributes, kSeconds, p.seconds) || !read_value(attributes, kRays, p.rays) ||
      !read_value(attributes, kComplete, complete))
    return Error{ErrorKind::input,
                 path.string() + ": not a reference of lueur's; make one with `lueur reference`"};
  rendering.complete = complete != 0;
  rendering.layers = std::move(layers);
  return rendering;
}

Result<CachedRendering> render_cached(const Scene& scene, const Shot& shot,
                                      const Settings& settings, const Control& control,
                                      std::span<const uint8_t> resume_from, Cache cache) {
  CachedRendering result;
  fs::path path;
  if (const fs::path folder = cache_folder(); cache == Cache::use && !folder.empty()) {
    std::error_code error;
    fs::create_directories(folder / "references", error);
    if (error)
      result.cache_note = (folder / "references").string() +
                          ": cannot be made, references are not kept: " + error.message();
    else
      path = folder / "references" / (finished_key(scene, shot, settings) + ".exr");
  }
  std::error_code ignored;
  if (!path.empty() && fs::exists(path, ignored)) {
    auto kept = read_rendering(path);
    if (kept.ok()) {
      result.rendering = std::move(*kept);
      result.from_cache = true;
      return result;
    }
    result.cache_note = kept.error().message + "; it is made anew";
  }
  LUEUR_TRY(rendering, render(scene, shot, settings, control, resume_from));
  result.rendering = std::move(rendering);
  // What was resumed from a longer rendering has more samples than the key says.
  const Progress& progress = result.rendering.progress;
  if (!path.empty() && result.rendering.complete && progress.spp_done <= progress.spp_total)
    if (const auto written = write_rendering(path, result.rendering); !written.ok())
      result.cache_note = written.error().message;
  return result;
}

}  // namespace lueur::reference
