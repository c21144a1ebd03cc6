// SPDX-License-Identifier: MIT
#include "render_output.h"

#include <algorithm>

#include "arguments.h"
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

Image8 composed_picture(std::span<const Pixels> pixels, const Development& development) {
  return to_display(as_image(*find_pixels(pixels, "composed"), 3), development.exposure_ev,
                    development.tone_map);
}

Result<const Pixels*> find_view(const std::string& view, const FrameRecord& frame) {
  if (const Pixels* pixels = find_pixels(frame.pixels, view)) return pixels;
  if (std::find(frame.written.begin(), frame.written.end(), view) != frame.written.end())
    return Error{ErrorKind::usage, "--view " + view +
                                       ": a cube map; only flat images can "
                                       "be shown, see --list-views"};
  return Error{ErrorKind::usage,
               "--view " + view + ": no such image; this frame has " + joined(frame.written)};
}

}  // namespace

Result<void> write_pictures(const std::vector<Destination>& destinations,
                            std::span<const Pixels> pixels, const Development& development) {
  for (const Destination& destination : destinations) {
    if (destination.kind == FileKind::png) {
      LUEUR_TRY_VOID(write_png(destination.path, composed_picture(pixels, development)));
    } else {
      LUEUR_TRY_VOID(write_exr(destination.path,
                               exr_layers(pixels, development.near_m, development.diffuse_alpha),
                               {.attributes = development.attributes}));
    }
  }
  return {};
}

Result<void> write_frame(const std::string& view, const std::vector<Destination>& destinations,
                         const FrameRecord& frame, const Development& development) {
  if (view.empty()) return write_pictures(destinations, frame.pixels, development);
  LUEUR_TRY(image, find_view(view, frame));
  for (const Destination& destination : destinations) {
    if (destination.kind == FileKind::png) {
      LUEUR_TRY_VOID(write_png(
          destination.path, view_picture(*image, development.exposure_ev, development.tone_map)));
    } else {
      LUEUR_TRY_VOID(write_as_is(destination.path, *image, development));
    }
  }
  return {};
}

Result<Image8> shown(const std::string& view, const FrameRecord& frame,
                     const Development& development) {
  if (view.empty()) return composed_picture(frame.pixels, development);
  LUEUR_TRY(image, find_view(view, frame));
  return view_picture(*image, development.exposure_ev, development.tone_map);
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
