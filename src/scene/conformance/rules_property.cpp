// SPDX-License-Identifier: MIT
// Cameras, lights and materials: properties that depend on each other.
#include <string>

#include "scene/conformance/rules.h"

namespace lueur::conformance {
namespace {

void check_camera(Asset& asset, const Json& camera, const std::string& path) {
  for (const char* kind : {"perspective", "orthographic"}) {
    const Json& lens = member(camera, kind);
    const std::string at = path_to(path, kind);
    const auto near = real_number(lens, "znear");
    const auto far = real_number(lens, "zfar");
    if (near && far && *far <= *near) asset.add(at, "zfar has to be more than znear");
    for (const char* key : {"xmag", "ymag"})
      if (real_number(lens, key) == 0.0) asset.add(path_to(at, key), "must not be 0");
    if (text(camera, "type") == kind && !lens.is_object())
      asset.add(path, std::string(kind) + " is missing");
  }
}

void check_light(Asset& asset, const Json& light, const std::string& path) {
  constexpr double kDefaultOuterCone = 0.7853981633974483;
  const Json& spot = member(light, "spot");
  if (text(light, "type") == "spot" && !spot.is_object()) asset.add(path, "spot is missing");
  const double inner = real_number(spot, "innerConeAngle").value_or(0.0);
  const double outer = real_number(spot, "outerConeAngle").value_or(kDefaultOuterCone);
  if (spot.is_object() && outer <= inner)
    asset.add(path_to(path_to(path, "spot"), "outerConeAngle"),
              "has to be more than the innerConeAngle");
}

}  // namespace

void check_cameras_and_lights(Asset& asset) {
  const Json& cameras = asset.list_of("cameras");
  for (size_t i = 0; i < cameras.size(); ++i)
    check_camera(asset, cameras[i], path_to("cameras", i));
  const Json& lights = list(member(asset.root, {"extensions", "KHR_lights_punctual"}), "lights");
  for (size_t i = 0; i < lights.size(); ++i)
    check_light(asset, lights[i], path_to("extensions.KHR_lights_punctual.lights", i));
}

void check_materials(Asset& asset) {
  const Json& materials = asset.list_of("materials");
  for (size_t i = 0; i < materials.size(); ++i) {
    const auto ior = real_number(member(materials[i], {"extensions", "KHR_materials_ior"}), "ior");
    if (ior && *ior > 0.0 && *ior < 1.0)
      asset.add(path_to("materials", i) + ".extensions.KHR_materials_ior.ior",
                "has to be 0, or 1 and more");
  }
}

}  // namespace lueur::conformance
