// SPDX-License-Identifier: MIT
#include "scene/builtin/builtin.h"

#include <array>
#include <charconv>
#include <string>
#include <utility>

#include "base/try.h"
#include "scene/builtin/detailed_object.h"
#include "scene/builtin/scenes.h"
#include "scene/scene_file.h"

namespace lueur {
namespace {

using builtin::kDefaultAtriumTriangles;
using builtin::kMaxAtriumTriangles;
using builtin::kMinAtriumTriangles;

Error usage(std::string message) {
  return {ErrorKind::usage, std::move(message)};
}

std::string atrium_range() {
  return std::to_string(kMinAtriumTriangles) + " to " + std::to_string(kMaxAtriumTriangles);
}

// Makes a scene that has no parameters.
template <Scene (*kMake)()>
Result<Scene> make_fixed(const SceneParameters& parameters) {
  Scene scene = kMake();
  if (parameters.triangles)
    return usage("built-in scene '" + scene.name +
                 "' has no parameter 'triangles'; only 'atrium' has one");
  return scene;
}

Result<Scene> make_atrium_checked(const SceneParameters& parameters) {
  const uint32_t triangles = parameters.triangles.value_or(kDefaultAtriumTriangles);
  if (triangles < kMinAtriumTriangles || triangles > kMaxAtriumTriangles)
    return usage("built-in scene 'atrium': triangles=" + std::to_string(triangles) +
                 " is out of range; give " + atrium_range());
  return builtin::make_atrium(triangles);
}

constexpr auto kScenes = std::to_array<BuiltinScene>({
    {"atrium", "colonnaded courtyard in the sun with coloured drapes (triangles=10000…1000000)",
     make_atrium_checked},
    {"basket", "a basket lit on the side that the camera does not see (91 000 triangles)",
     make_fixed<builtin::make_basket>},
    {"cornell", "the measured Cornell box, ten times its size", make_fixed<builtin::make_cornell>},
    {"divider-room",
     "a dragon of 60 000 triangles on its way around a divider in a coloured room (70 000)",
     make_fixed<builtin::make_divider_room>, true},
    {"dominoes", "coloured dominoes toppling over a polished floor (1400 triangles)",
     make_fixed<builtin::make_dominoes>},
    {"floating-object", "a dragon of 69 000 triangles afloat in a box under a spotlight (70 000)",
     make_fixed<builtin::make_floating_object>, true},
    {"graveyard", "tombstones, crypt and bare trees by moonlight (120000 triangles)",
     make_fixed<builtin::make_graveyard>},
    {"spot-floor", "objects lit only by a spotlight's disc on the floor",
     make_fixed<builtin::make_spot_floor>},
    {"still-life", "vessels, fruit and a skull, lit also by letters out of view (200000 triangles)",
     make_fixed<builtin::make_still_life>},
    {"table", "a table and its soft shadow in the light of a sunlit wall (58 000 triangles)",
     make_fixed<builtin::make_table>},
    {"three-lights", "a hall with a sun, a spotlight and a bulb (10 000 triangles)",
     make_fixed<builtin::make_three_lights>},
});

std::string scene_names() {
  std::string names;
  for (const BuiltinScene& scene : kScenes) {
    if (!names.empty()) names += ", ";
    names += scene.name;
  }
  return names;
}

std::string scenes_with_object() {
  std::string names;
  for (const BuiltinScene& scene : kScenes)
    if (scene.has_object) names += (names.empty() ? "" : ", ") + std::string(scene.name);
  return names;
}

// Reads `triangles=N`, `object=FILE` or both, in this order.
Result<SceneParameters> parse_parameters(std::string_view spec, std::string_view text) {
  const std::string where = "built-in scene '" + std::string(spec) + "': ";
  constexpr std::string_view kTriangles = "triangles=", kObject = "object=";
  SceneParameters parameters;
  if (text.starts_with(kTriangles)) {
    const std::string_view digits =
        text.substr(kTriangles.size(), text.find(',') - kTriangles.size());
    uint32_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size())
      return usage(where + "triangles must be a whole number from " + atrium_range() + ", not '" +
                   std::string(digits) + "'");
    parameters.triangles = value;
    text.remove_prefix(kTriangles.size() + digits.size());
    if (text.empty()) return parameters;
    text.remove_prefix(1);
  }
  if (!text.starts_with(kObject))
    return usage(where + "unknown parameter '" + std::string(text) +
                 "'; there are triangles=N and object=FILE");
  if (text == kObject) return usage(where + "object= (or --object) needs the name of a file");
  parameters.object = text.substr(kObject.size());
  return parameters;
}

// Makes the scene with the mesh in `path` in the place of its own object.
Result<Scene> make_with_object(const BuiltinScene& known, SceneParameters parameters) {
  const std::filesystem::path path = *std::exchange(parameters.object, std::nullopt);
  LUEUR_TRY(object, load_scene_file(path));
  LUEUR_TRY(scene, known.make(parameters));
  if (!builtin::replace_detailed_object(scene, std::move(object)))
    return Error{ErrorKind::input, "object '" + path.string() +
                                       "': draws no triangles that have a size; give a mesh"};
  return std::move(scene);
}

}  // namespace

std::span<const BuiltinScene> builtin_scenes() {
  return kScenes;
}

Result<Scene> make_builtin_scene(std::string_view name, const SceneParameters& parameters) {
  for (const BuiltinScene& known : kScenes) {
    if (known.name != name) continue;
    if (parameters.object && !known.has_object)
      return usage("built-in scene '" + std::string(name) +
                   "' has no object that another can take the place of; these have: " +
                   scenes_with_object());
    return parameters.object ? make_with_object(known, parameters) : known.make(parameters);
  }
  return usage("no built-in scene is called '" + std::string(name) + "'; there are " +
               scene_names());
}

Result<Scene> make_builtin_scene(std::string_view spec) {
  const size_t colon = spec.find(':');
  if (colon == std::string_view::npos) return make_builtin_scene(spec, SceneParameters{});
  LUEUR_TRY(parameters, parse_parameters(spec, spec.substr(colon + 1)));
  return make_builtin_scene(spec.substr(0, colon), parameters);
}

}  // namespace lueur
