// SPDX-License-Identifier: MIT
#include "environment_choice.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <glm/gtc/constants.hpp>

#include "arguments.h"
#include "base/file.h"
#include "base/try.h"
#include "image/exr.h"
#include "image/hdr.h"

namespace lueur::cli {
namespace {

constexpr uint64_t kMaxFileBytes = uint64_t{1} << 30;
constexpr float kMaxRadiance = 1e9f;  // the sun's disc

Result<ImageF> main_picture(const std::vector<uint8_t>& bytes, const std::string& file) {
  constexpr uint8_t kExrMagic[] = {0x76, 0x2f, 0x31, 0x01};
  if (is_hdr(bytes)) return decode_hdr(bytes, file);
  if (bytes.size() < 4 || !std::equal(std::begin(kExrMagic), std::end(kExrMagic), bytes.begin()))
    return Error{ErrorKind::input, file + ": neither OpenEXR nor Radiance (.hdr); convert it"};
  LUEUR_TRY(layers, decode_exr(bytes, file));
  std::vector<std::string> names;
  for (ImageLayer& layer : layers) {
    if (layer.name.empty() && (layer.image.channels == 1 || layer.image.channels >= 3))
      return std::move(layer.image);
    names.push_back("'" + layer.name + "'");
  }
  return Error{ErrorKind::input, file + ": has no main picture of R, G and B, only the layers " +
                                     joined(names) + "; write it with channels R, G, B"};
}

}  // namespace

void add_environment_options(CLI::App& command, EnvironmentOptions& options) {
  command.add_option("--env", options.file, "Light around the scene: a picture, .hdr or .exr")
      ->type_name("FILE");
  command
      .add_option("--env-rotation", options.rotation_deg,
                  "Turns it counter-clockwise seen from above (default 0)")
      ->type_name("DEG");
  command.add_option("--env-intensity", options.intensity, "Multiplies it (default 1)")
      ->type_name("X");
}

Result<EnvironmentChoice> check(const EnvironmentOptions& options) {
  EnvironmentChoice choice{.file = options.file};
  for (const auto& [flag, text] : {std::pair("--env-rotation", &options.rotation_deg),
                                   std::pair("--env-intensity", &options.intensity)})
    if (options.file.empty() && !text->empty())
      return Error{ErrorKind::usage, std::string(flag) + " needs a picture; add --env FILE"};
  if (!options.rotation_deg.empty()) {
    LUEUR_TRY(degrees, parse_real("--env-rotation", options.rotation_deg, 1e6f));
    choice.rotation_rad = glm::radians(std::fmod(degrees, 360.0f));
  }
  if (!options.intensity.empty()) {
    LUEUR_TRY(intensity, parse_real("--env-intensity", options.intensity, 1e6f));
    if (intensity < 0.0f)
      return Error{ErrorKind::usage,
                   "--env-intensity '" + options.intensity + "': expected 0 or more"};
    choice.intensity = intensity;
  }
  return choice;
}

Result<Environment> load_environment(const EnvironmentChoice& choice,
                                     std::vector<std::string>& warnings) {
  LUEUR_TRY(bytes, read_file(choice.file, kMaxFileBytes));
  LUEUR_TRY(picture, main_picture(bytes, choice.file));
  Environment environment{.name = std::filesystem::path(choice.file).stem().string(),
                          .width = picture.width,
                          .height = picture.height,
                          .rotation_rad = choice.rotation_rad,
                          .intensity = choice.intensity};
  const size_t pixels = size_t{picture.width} * picture.height;
  environment.rgb.reserve(pixels * 3);
  uint64_t changed = 0;
  for (size_t i = 0; i < pixels; ++i) {
    for (size_t c = 0; c < 3; ++c) {
      const float sample = picture.samples[i * picture.channels + (picture.channels < 3 ? 0 : c)];
      // NaN compares with nothing.
      const float radiance = sample > 0.0f ? std::min(sample, kMaxRadiance) : 0.0f;
      if (radiance != sample) ++changed;
      environment.rgb.push_back(radiance);
    }
  }
  if (changed > 0)
    warnings.push_back(choice.file + ": " + std::to_string(changed) +
                       " samples are negative, not finite or above 1e9: taken as 0 or as 1e9");
  if (picture.width != 2 * picture.height)
    warnings.push_back(choice.file + ": is not twice as wide as high: stretched over the sphere");
  return environment;
}

}  // namespace lueur::cli
