// SPDX-License-Identifier: MIT
// lueur scene: what there is to render, what is in it, and a way out to other programs.
#include <CLI/CLI.hpp>
#include <glm/gtc/constants.hpp>
#include <memory>
#include <sstream>

#include "arguments.h"
#include "base/try.h"
#include "commands.h"
#include "console.h"
#include "destination.h"
#include "frame_options.h"
#include "json_output.h"
#include "limit_option.h"
#include "scene/builtin/builtin.h"
#include "scene/deform.h"
#include "scene/gltf_export.h"
#include "scene/watertight.h"
#include "session.h"

namespace lueur::cli {
namespace {

struct SceneOptions {
  std::string scene;
  LoadLimits limits;
  std::string output;
  bool json = false;
};

Json vector_json(const glm::vec3& v) {
  return Json::array({as_printed(v.x), as_printed(v.y), as_printed(v.z)});
}

const char* kind_name(LightKind kind) {
  switch (kind) {
    case LightKind::point:
      return "point";
    case LightKind::spot:
      return "spot";
    case LightKind::directional:
      return "directional";
  }
  return "";
}

float animation_length_s(const Scene& scene) {
  float length_s = 0;
  for (const AnimationChannel& channel : scene.animation)
    if (!channel.times_s.empty()) length_s = std::max(length_s, channel.times_s.back());
  return length_s;
}

Json cameras_json(const Scene& scene) {
  Json list = Json::array();
  for (const Camera& camera : scene.cameras)
    list.push_back({{"name", camera.name},
                    {"vertical_fov_deg", as_printed(glm::degrees(camera.vertical_fov_rad))},
                    {"near_m", as_printed(camera.near_m)}});
  return list;
}

// Intensity in candela, or in lux for directional lights.
Json lights_json(const Scene& scene) {
  Json list = Json::array();
  for (const Light& light : scene.lights)
    list.push_back({{"name", light.name},
                    {"kind", kind_name(light.kind)},
                    {"intensity", as_printed(light.intensity)},
                    {"unit", light.kind == LightKind::directional ? "lx" : "cd"},
                    {"color", vector_json(light.color)}});
  return list;
}

Json textures_json(const Scene& scene) {
  Json list = Json::array();
  for (const Texture& texture : scene.textures)
    list.push_back({{"name", texture.name}, {"size", {texture.width, texture.height}}});
  return list;
}

Json materials_json(const Scene& scene) {
  Json list = Json::array();
  for (const Material& material : scene.materials)
    list.push_back({{"name", material.name},
                    {"metallic", as_printed(material.metallic)},
                    {"roughness", as_printed(material.roughness)},
                    {"emits", material.emission != glm::vec3(0.0f)}});
  return list;
}

// What the scene's vertices, indices and texels take in memory.
uint64_t data_bytes(const Scene& scene) {
  uint64_t bytes = 0;
  for (const Texture& texture : scene.textures) bytes += texture.rgba.size();
  for (const Mesh& mesh : scene.meshes) {
    bytes += mesh.vertices.size() * sizeof(Vertex) + mesh.indices.size() * sizeof(uint32_t) +
             mesh.influences.size() * sizeof(JointInfluence);
    for (const MorphTarget& target : mesh.morph_targets)
      bytes += (target.positions.size() + target.normals.size() + target.tangents.size()) *
               sizeof(glm::vec3);
  }
  return bytes;
}

// Which meshes bound solids, each counted once.
Json closed_json(const Scene& scene) {
  uint64_t closed = 0, open = 0;
  Json open_meshes = Json::array();
  for (const Mesh& mesh : scene.meshes) {
    const Watertightness found = watertightness(mesh);
    closed += found.closed_triangles;
    open += found.open_triangles;
    if (found.open_triangles > 0)
      open_meshes.push_back({{"name", mesh.name},
                             {"open_triangles", found.open_triangles},
                             {"open_edges", found.open_edges}});
  }
  return {{"closed_triangles", closed}, {"open_triangles", open}, {"open_meshes", open_meshes}};
}

// One line: how much is closed, and the first meshes that are not.
std::string closed_text(const Json& closed) {
  constexpr size_t kMostNames = 3;
  const uint64_t count = closed["closed_triangles"];
  std::string text = "closed: " + std::to_string(count) + " of " +
                     std::to_string(count + closed["open_triangles"].get<uint64_t>()) +
                     " triangles bound solids";
  const Json& open = closed["open_meshes"];
  for (size_t i = 0; i < std::min(open.size(), kMostNames); ++i)
    text += (i == 0 ? "; open: " : ", ") + printable(open[i]["name"].get<std::string>());
  if (open.size() > kMostNames)
    text += " and " + std::to_string(open.size() - kMostNames) + " more meshes";
  return text + "\n";
}

Json info_json(const std::string& spec, const LoadedScene& loaded) {
  const Scene& scene = loaded.scene;
  const Bounds box = bounds_at(scene, 0.0f);
  uint64_t vertices = 0;
  for (const Mesh& mesh : scene.meshes) vertices += mesh.vertices.size();
  Json json = {{"scene", spec},
               {"name", scene.name},
               {"triangles", triangle_count(scene)},
               {"vertices", vertices},
               {"meshes", scene.meshes.size()},
               {"instances", scene.instances.size()},
               {"nodes", scene.nodes.size()},
               {"solids", closed_json(scene)},
               {"data_bytes", data_bytes(scene)},
               {"bounds_m", {{"min", vector_json(box.min)}, {"max", vector_json(box.max)}}},
               {"animation_s", as_printed(animation_length_s(scene))},
               {"cameras", cameras_json(scene)},
               {"lights", lights_json(scene)},
               {"materials", materials_json(scene)},
               {"textures", textures_json(scene)}};
  if (scene.exposure_ev) json["exposure_ev"] = as_printed(*scene.exposure_ev);
  json["load_ms"] = rounded_ms(loaded.load_ms);
  json["warnings"] = scene.warnings;
  return json;
}

std::string info_text(const Json& info) {
  const auto text = [](const Json& value) {
    return printable(value.is_string() ? value.get<std::string>() : value.dump());
  };
  std::ostringstream out;
  for (const char* key : {"name", "triangles", "vertices", "meshes", "instances", "nodes"})
    out << key << ": " << text(info[key]) << "\n";
  out << closed_text(info["solids"]);
  out << "bounds: " << text(info["bounds_m"]["min"]) << " to " << text(info["bounds_m"]["max"])
      << " m\n";
  out << "data: " << text(info["data_bytes"]) << " bytes\n";
  out << "animation: " << text(info["animation_s"]) << " s\n";
  if (info.contains("exposure_ev")) out << "exposure: " << text(info["exposure_ev"]) << " EV\n";
  for (const auto& camera : info["cameras"])
    out << "camera: " << text(camera["name"]) << ", " << text(camera["vertical_fov_deg"])
        << " degrees high\n";
  for (const auto& light : info["lights"])
    out << "light: " << text(light["name"]) << ", " << text(light["kind"]) << ", "
        << text(light["intensity"]) << " " << text(light["unit"]) << "\n";
  out << "materials: " << info["materials"].size() << "\n"
      << "textures: " << info["textures"].size() << "\n";
  return out.str();
}

Outcome run_list(const SceneOptions& options) {
  Json list = Json::array();
  std::string text;
  for (const BuiltinScene& scene : builtin_scenes()) {
    list.push_back({{"name", scene.name}, {"summary", scene.summary}});
    text += std::string(scene.name) + ": " + std::string(scene.summary) + "\n";
  }
  LUEUR_TRY_VOID(options.json ? print_json({{"scenes", list}}) : print_data(text));
  return kExitDone;
}

Outcome run_info(const SceneOptions& options) {
  LUEUR_TRY(loaded, load_scene(options.scene, {}, options.limits));
  for (const std::string& warning : loaded.scene.warnings) print_warning(warning);
  const Json info = info_json(options.scene, loaded);
  LUEUR_TRY_VOID(options.json ? print_json(info) : print_data(info_text(info)));
  return kExitDone;
}

Outcome run_export(const SceneOptions& options) {
  if (ending_of(options.output) != ".glb")
    return Error{ErrorKind::usage, "-o '" + options.output + "': the name has to end in .glb"};
  LUEUR_TRY_VOID(check_writable(options.output));
  LUEUR_TRY(loaded, load_scene(options.scene, {}, options.limits));
  for (const std::string& warning : loaded.scene.warnings) print_warning(warning);
  for (const Material& material : loaded.scene.materials)
    if (material.phong)
      print_warning("material '" + material.name +
                    "': its Phong lobe is left out, as glTF has none");
  LUEUR_TRY_VOID(export_glb(loaded.scene, options.output));
  print_progress("wrote " + options.output);
  return kExitDone;
}

}  // namespace

void add_scene(CLI::App& program, Outcome& outcome) {
  CLI::App* command = program.add_subcommand("scene", "List, describe, draw and export scenes");
  command->require_subcommand(1);
  command->footer(std::string("Examples:\n"
                              "  lueur scene list\n"
                              "  lueur scene info room.glb --json\n"
                              "  lueur scene sheet models -o models.html\n"
                              "  lueur scene export atrium:triangles=250000 -o atrium.glb\n") +
                  kExitCodes);
  auto options = std::make_shared<SceneOptions>();
  const auto add_json = [&](CLI::App* sub) {
    sub->add_flag("--json", options->json, "One JSON object on stdout");
  };

  CLI::App* list = command->add_subcommand("list", "List the built-in scenes");
  add_json(list);
  list->footer(std::string("Examples:\n  lueur scene list\n") + kExitCodes);
  list->callback([options, &outcome] { outcome = run_list(*options); });

  CLI::App* info = command->add_subcommand("info", "Say what is in a scene");
  add_scene_argument(*info, options->scene);
  add_limit_option(*info, options->limits);
  add_json(info);
  info->footer(std::string("Examples:\n  lueur scene info cornell\n"
                           "  lueur scene info room.glb --json\n") +
               kExitCodes);
  info->callback([options, &outcome] { outcome = run_info(*options); });

  CLI::App* out = command->add_subcommand("export", "Write a scene as a binary glTF file");
  add_scene_argument(*out, options->scene);
  add_limit_option(*out, options->limits);
  out->add_option("-o,--output", options->output, "Ends in .glb")->type_name("FILE")->required();
  out->footer(std::string("Examples:\n"
                          "  lueur scene export atrium:triangles=250000 -o atrium.glb\n") +
              kExitCodes);
  out->callback([options, &outcome] { outcome = run_export(*options); });

  add_scene_sheet(*command, outcome);
}

}  // namespace lueur::cli
