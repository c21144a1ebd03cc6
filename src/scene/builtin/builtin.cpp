// SPDX-License-Identifier: MIT
#include "scene/builtin/builtin.h"

#include <array>
#include <charconv>
#include <string>
#include <utility>

#include "base/try.h"
#include "scene/builtin/scenes.h"

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
    {"cornell", "the measured Cornell box, ten times its size", make_fixed<builtin::make_cornell>},
    {"spot-floor", "objects lit only by a spotlight's disc on the floor",
     make_fixed<builtin::make_spot_floor>},
    {"divider-room", "a dragon of 60 000 triangles on its way around a divider in a coloured room",
     make_fixed<builtin::make_divider_room>},
    {"floating-object", "a dragon of 70 000 triangles afloat in a box under a spotlight",
     make_fixed<builtin::make_floating_object>},
});

std::string scene_names() {
  std::string names;
  for (const BuiltinScene& scene : kScenes) {
    if (!names.empty()) names += ", ";
    names += scene.name;
  }
  return names;
}

// Reads `triangles=N`.
Result<SceneParameters> parse_parameters(std::string_view spec, std::string_view text) {
  const std::string where = "built-in scene '" + std::string(spec) + "': ";
  constexpr std::string_view kTriangles = "triangles=";
  if (!text.starts_with(kTriangles))
    return usage(where + "unknown parameter '" + std::string(text) +
                 "'; the only one is triangles=N");
  const std::string_view digits = text.substr(kTriangles.size());
  uint32_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size())
    return usage(where + "triangles must be a whole number from " + atrium_range() + ", not '" +
                 std::string(digits) + "'");
  SceneParameters parameters;
  parameters.triangles = value;
  return parameters;
}

}  // namespace

std::span<const BuiltinScene> builtin_scenes() {
  return kScenes;
}

Result<Scene> make_builtin_scene(std::string_view name, const SceneParameters& parameters) {
  for (const BuiltinScene& scene : kScenes)
    if (scene.name == name) return scene.make(parameters);
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
