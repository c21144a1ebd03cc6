// SPDX-License-Identifier: MIT
// Scenes that need no files: made by formulas, the same bits every time on one machine and build.
// All are right-handed, y up, in metres, lit in candela and lux; their meshes are closed
// (watertight, counter-clockwise outwards), each has at least one camera and one light, and the
// first camera and something in the scene move on a loop of ten seconds. `exposure_ev` shows a
// white surface lit by the main light at about 0.9.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

#include "lueur/result.h"
#include "scene/scene.h"

namespace lueur {

// What a caller may ask of a built-in scene. A scene refuses a parameter that it does not have
// (ErrorKind::usage, one line that names the scene).
struct SceneParameters {
  // Triangles drawn, met within 10 %. Only `atrium` has it: 10 000 … 1 000 000, 100 000 by default.
  std::optional<uint32_t> triangles;

  // A mesh file that takes the place of the scene's detailed object: scaled as a whole to fit the
  // object's box, on the same spot, with its materials and textures and nothing else. Only scenes
  // with `has_object` have it.
  std::optional<std::filesystem::path> object;
};

struct BuiltinScene {
  std::string_view name;
  std::string_view summary;  // half a line for --help
  Result<Scene> (*make)(const SceneParameters& parameters);
  bool has_object = false;  // takes SceneParameters::object
};

// In the order in which a help text should list them.
std::span<const BuiltinScene> builtin_scenes();

// Makes a scene from its name as a user types it: `atrium`, `atrium:triangles=250000` or
// `divider-room:object=figure.glb`; parameters are parted by commas, and `object` is the last, as
// its path may hold commas. Fails (ErrorKind::usage) on an unknown name or parameter and on a value
// out of range; the message names the valid ones. An object's file fails as load_gltf() does.
Result<Scene> make_builtin_scene(std::string_view spec);
Result<Scene> make_builtin_scene(std::string_view name, const SceneParameters& parameters);

}  // namespace lueur
