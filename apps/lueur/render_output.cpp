// SPDX-License-Identifier: MIT
#include "render_output.h"

#include <algorithm>

#include "base/try.h"
#include "image/exr.h"
#include "image/png.h"
#include "picture.h"
#include "view_picture.h"

namespace lueur::cli {
namespace {

// All channels as 32-bit floats, so that nothing is lost.
Result<void> write_as_is(const std::filesystem::path& path, const Pixels& pixels,
                         const Development& development) {
  const ImageLayer layers[] = {{"", as_image(pixels, pixels.channels)}};
  ExrOptions options{.float_layers = {""}, .attributes = development.attributes};
  options.attributes["lueur.view"] = pixels.name;
  return write_exr(path, layers, options);
}

}  // namespace

Result<void> write_pictures(const std::vector<Destination>& destinations,
                            std::span<const Pixels> pixels, const Development& development) {
  for (const Destination& destination : destinations) {
    if (destination.kind == FileKind::png) {
      const ImageF composed = as_image(*find_pixels(pixels, "composed"), 3);
      LUEUR_TRY_VOID(write_png(
          destination.path, to_display(composed, development.exposure_ev, development.tone_map)));
    } else {
      LUEUR_TRY_VOID(write_exr(destination.path, exr_layers(pixels, development.near_m),
                               {.attributes = development.attributes}));
    }
  }
  return {};
}

Result<void> write_view(const std::vector<Destination>& destinations, const Pixels& view,
                        const Development& development) {
  for (const Destination& destination : destinations) {
    if (destination.kind == FileKind::png) {
      LUEUR_TRY_VOID(write_png(destination.path,
                               view_picture(view, development.exposure_ev, development.tone_map)));
    } else {
      LUEUR_TRY_VOID(write_as_is(destination.path, view, development));
    }
  }
  return {};
}

Result<std::vector<std::string>> write_dumps(const std::filesystem::path& folder,
                                             std::span<const Pixels> pixels,
                                             const Development& development) {
  std::map<std::string, int> times_seen;
  std::vector<std::string> paths;
  for (const Pixels& image : pixels) {
    // Names without a dot are the renderer's own, read back for the picture.
    if (image.name.find('.') == std::string::npos) continue;
    std::string name = image.name;
    std::replace(name.begin(), name.end(), '/', '_');
    const int count = ++times_seen[name];
    if (count > 1) name += "." + std::to_string(count);
    const std::filesystem::path path = folder / (name + ".exr");
    LUEUR_TRY_VOID(write_as_is(path, image, development));
    paths.push_back(path.string());
  }
  return paths;
}

}  // namespace lueur::cli
