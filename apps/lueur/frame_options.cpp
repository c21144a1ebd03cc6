// SPDX-License-Identifier: MIT
#include "frame_options.h"

#include <CLI/CLI.hpp>

#include "arguments.h"
#include "base/try.h"
#include "scene/scene_file.h"

namespace lueur::cli {

void add_view_options(CLI::App& command, FrameOptions& options) {
  command.add_option("--size", options.size, "In pixels (default " + options.size + ")")
      ->type_name("WxH");
  command.add_option("--camera", options.camera, "A camera's name or number (default: first)")
      ->type_name("NAME|N");
  command.add_option("--seed", options.seed, "Pattern of samples (default 0)")->type_name("N");
  add_environment_options(command, options.environment);
}

void add_frame_options(CLI::App& command, FrameOptions& options) {
  add_view_options(command, options);
  command
      .add_option("--side-camera", options.side_cameras,
                  "A camera that a technique may look through, too; may be repeated")
      ->type_name("NAME|N")
      ->allow_extra_args(false);
  command.add_option("--device", options.device, "Number or name, see `lueur devices`")
      ->type_name("N|NAME");
}

void add_technique_options(CLI::App& command, TechniqueOptions& options) {
  command
      .add_option("--technique", options.name,
                  "Of `lueur techniques`, or none (default hierarchical)")
      ->type_name("NAME");
  command.add_option("--preset", options.preset, "Settings that go together; --set goes on top")
      ->type_name("NAME");
  command.add_option("--set", options.settings, "A setting of the technique; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

Result<ChosenTechnique> check(const TechniqueOptions& options) {
  return choose_technique(options.name, options.settings, options.preset);
}

void add_object_option(CLI::App& command, std::string& scene) {
  command
      .add_option_function<std::string>(
          "--object",
          [&scene](const std::string& file) {
            scene += (scene.find(':') == std::string::npos ? ":object=" : ",object=") + file;
          },
          "A mesh in place of a built-in scene's detailed object")
      ->type_name("FILE");
}

void add_scene_argument(CLI::App& command, std::string& scene) {
  command
      .add_option("SCENE", scene,
                  "A built-in scene, or a file (" + std::string(kSceneFileEndings) + ")")
      ->type_name("")
      ->required();
  add_object_option(command, scene);
}

Result<FrameSetup> check(const FrameOptions& options) {
  LUEUR_TRY(size, parse_size("--size", options.size));
  LUEUR_TRY(seed, parse_count("--seed", options.seed, 0, UINT32_MAX));
  LUEUR_TRY(environment, check(options.environment));
  return FrameSetup{size, seed, environment};
}

}  // namespace lueur::cli
