// SPDX-License-Identifier: MIT
#include "lueur/cube_map.h"

#include <array>
#include <map>

#include "frame/recorder.h"
#include "techniques/cube_map/cube_map_frame.h"

namespace lueur {
namespace {

using Settings = CubeMapSettings;
using cube_map::CubeMapFrame;
using cube_map::Maps;
using cube_map::pixels_of;
using cube_map::side_of;

constexpr std::string_view kSideNames[] = {"2", "4", "8", "16", "32", "64", "128", "256"};
constexpr std::string_view kPictureNames[] = {"64", "128", "256", "512"};
constexpr std::string_view kCentreNames[] = {"object", "scene"};
constexpr std::string_view kMethodNames[] = {"localized", "classical"};

constexpr std::array kSettings = {
    choice<&Settings::side>("side", kSideNames, "Texels along a side of a map's faces."),
    choice<&Settings::picture>("picture", kPictureNames,
                               "Pixels along a side of the pictures that they are averaged from."),
    choice<&Settings::method>(
        "method", kMethodNames,
        "localized: texels as each pixel sees them; classical: all as the centre does, convolved."),
    toggle<&Settings::glossy>("glossy",
                              "Also give the light that glossy lobes reflect; needs reflectance."),
    setting<&Settings::blinn_exponent>(
        "blinn_exponent", 0, 1000, "",
        "Shininess of the paper's lobe, which then all surfaces have; 0: their own lobes."),
    choice<&Settings::centre>("centre", kCentreNames,
                              "Where maps of objects stand: in the middle of their objects, or of "
                              "all that is drawn."),
    setting<&Settings::most_maps>("most_maps", 1, 64, "maps",
                                  "Of objects. With more of those, more of them share a map."),
    setting<&Settings::share>(
        "share", 0, 16, "radii",
        "How large the ball around objects with one map may be, in those around the largest; 0: "
        "none share."),
    setting<&Settings::probes>("probes", 0, 3, "probes",
                               "Along the longest side of what is drawn, for what stands still."),
    setting<&Settings::faces_a_frame>("faces_a_frame", 1, 600, "faces",
                                      "Captured in a frame at most, but for those never captured."),
    setting<&Settings::move_threshold>("move_threshold", 0, 1, "radii",
                                       "How far an object moves before maps are captured again."),
};

}  // namespace

// What a technique knows of the frame before, by RecorderOptions::history_of.
struct CubeMap::Memory {
  std::map<std::string, Maps> maps;
};

CubeMap::CubeMap(CubeMapSettings settings)
    : settings_(settings), memory_(std::make_unique<Memory>()) {}
CubeMap::~CubeMap() = default;

std::span<const SettingInfo> CubeMap::settings_table() {
  return kSettings;
}

Outputs CubeMap::render(Frame& public_frame, const Inputs& inputs) {
  Recorder& frame = public_frame.recorder();
  const auto fail = [&](const char* message) { frame.fail({ErrorKind::usage, message}); };
  if (auto valid = check_ranges(kSettings, &settings_); !valid.ok()) frame.fail(valid.error());
  if (side_of(settings_.side) > pixels_of(settings_.picture))
    fail("cube_map: `side` is above `picture`, from whose pixels its texels are averaged");
  if (settings_.method == Settings::Method::classical && side_of(settings_.side) > 64)
    fail("cube_map with method=classical takes no `side` above 64: convolving would take too long");
  if (!inputs.host)
    fail("cube_map needs an engine that renders the faces of its maps (Inputs::host)");
  if (settings_.glossy && !inputs.g_buffer.reflectance.valid())
    fail("cube_map with glossy needs GBuffer::reflectance");
  if (frame.failed()) return {};

  CubeMapFrame steps(public_frame, settings_, inputs, memory_->maps[frame.options.history_of]);
  steps.capture();
  if (frame.failed()) return {};
  Outputs outputs{.diffuse = steps.gather(false)};
  if (settings_.glossy) outputs.specular = steps.gather(true);
  if (frame.failed()) return {};
  return outputs;
}

}  // namespace lueur
