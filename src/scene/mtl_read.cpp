// SPDX-License-Identifier: MIT
#include "scene/mtl_read.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/try.h"
#include "scene/gltf_json.h"
#include "scene/obj_text.h"

namespace lueur {
namespace {

constexpr size_t kMaxWords = 256;

struct ColorStatement {
  std::string_view keyword;
  std::optional<glm::vec3> MtlMaterial::*field;
};
constexpr std::array kColors{ColorStatement{"Kd", &MtlMaterial::diffuse},
                             ColorStatement{"Ks", &MtlMaterial::specular},
                             ColorStatement{"Ke", &MtlMaterial::emission}};

struct NumberStatement {
  std::string_view keyword;
  std::optional<float> MtlMaterial::*field;
};
constexpr std::array kNumbers{NumberStatement{"Ns", &MtlMaterial::shininess},
                              NumberStatement{"Pr", &MtlMaterial::roughness},
                              NumberStatement{"Pm", &MtlMaterial::metallic}};

struct MapStatement {
  std::string_view keyword;
  std::optional<MtlMap> MtlMaterial::*field;
};
constexpr std::array kMaps{MapStatement{"map_Kd", &MtlMaterial::diffuse_map},
                           MapStatement{"map_Ke", &MtlMaterial::emission_map},
                           MapStatement{"map_d", &MtlMaterial::dissolve_map},
                           MapStatement{"map_Bump", &MtlMaterial::bump_map},
                           MapStatement{"map_bump", &MtlMaterial::bump_map},
                           MapStatement{"bump", &MtlMaterial::bump_map},
                           MapStatement{"norm", &MtlMaterial::normal_map},
                           MapStatement{"map_Pr", &MtlMaterial::roughness_map},
                           MapStatement{"map_Pm", &MtlMaterial::metallic_map}};

// Statements without a meaning here whose absence does not show.
constexpr std::array<std::string_view, 8> kWithoutLoss = {
    "Ka", "Ni", "sharpness", "aniso", "map_aat", "anisor", "Km", "map_Ka"};

template <class Rows>
auto row_of(const Rows& rows, std::string_view keyword) {
  return std::ranges::find_if(rows, [&](const auto& row) { return row.keyword == keyword; });
}

class MtlReader {
 public:
  MtlReader(std::string_view text, const std::string& file, Warnings& warnings)
      : lines_(text, file, kMaxWords), warnings_(&warnings) {}

  Result<std::vector<MtlMaterial>> read() {
    for (;;) {
      LUEUR_TRY(more, lines_.next());
      if (!more) return std::move(materials_);
      if (lines_.words()[0] == "newmtl") {
        materials_.push_back({.name = std::string(lines_.rest_from(1)), .place = place()});
      } else if (!materials_.empty()) {
        LUEUR_TRY_VOID(read_statement(materials_.back()));
      } else {
        return lines_.error(in_quotes(lines_.words()[0]) +
                            " stands before the first newmtl; this is not an MTL file");
      }
    }
  }

 private:
  std::string place() const { return lines_.file() + ": line " + std::to_string(lines_.line()); }
  Result<void> read_statement(MtlMaterial& material);
  Result<std::optional<glm::vec3>> read_color();
  Result<float> read_number();
  std::optional<MtlMap> read_map();
  size_t read_option(size_t at, MtlMap& map);
  size_t read_vector(size_t at, glm::vec2& value) const;

  ObjLines lines_;
  Warnings* warnings_;
  std::vector<MtlMaterial> materials_;
};

Result<void> MtlReader::read_statement(MtlMaterial& material) {
  const std::string_view keyword = lines_.words()[0];
  if (const auto color = row_of(kColors, keyword); color != kColors.end()) {
    LUEUR_TRY(value, read_color());
    if (value) material.*color->field = value;
  } else if (const auto number = row_of(kNumbers, keyword); number != kNumbers.end()) {
    LUEUR_TRY(value, read_number());
    material.*number->field = value;
  } else if (const auto map = row_of(kMaps, keyword); map != kMaps.end()) {
    if (auto value = read_map()) material.*map->field = std::move(value);
  } else if (keyword == "d" || keyword == "Tr") {
    LUEUR_TRY(value, read_number());
    // Both may be there; d is the one that all writers agree on.
    if (keyword == "d")
      material.dissolve = value;
    else if (!material.dissolve)
      material.dissolve = 1.0f - value;
  } else if (keyword == "Tf") {
    LUEUR_TRY(value, read_color());
    material.is_clear = material.is_clear || (value && *value != glm::vec3(1.0f));
  } else if (keyword == "illum") {
    LUEUR_TRY(model, read_number());
    material.is_clear =
        material.is_clear || model == 4.0f || model == 6.0f || model == 7.0f || model == 9.0f;
    material.has_gloss = model > 1.0f;
  } else if (std::ranges::find(kWithoutLoss, keyword) == kWithoutLoss.end()) {
    warnings_->add("materials: " + in_quotes(keyword) + " is not supported: drawn without it");
  }
  return {};
}

// One number stands for a grey. None for spectra and CIE colours.
Result<std::optional<glm::vec3>> MtlReader::read_color() {
  if (lines_.words().size() > 1 &&
      (lines_.words()[1] == "spectral" || lines_.words()[1] == "xyz")) {
    warnings_->add("materials: colours as spectra or CIE XYZ are left out");
    return std::optional<glm::vec3>();
  }
  std::array<float, 3> v{};
  LUEUR_TRY(count, lines_.numbers(v, 1));
  if (count < 3) v[1] = v[2] = v[0];
  return std::optional(glm::vec3(v[0], v[1], v[2]));
}

// "d -halo 0.5" tells its number last.
Result<float> MtlReader::read_number() {
  const auto words = lines_.words();
  if (words.size() > 2 && words[1] == "-halo") {
    warnings_->add("materials: 'd -halo' is read as 'd'");
    const std::optional<float> value = number_of(words[2]);
    if (!value) return lines_.error(in_quotes(words[2]) + " is not a finite number");
    return *value;
  }
  std::array<float, 1> value{};
  LUEUR_TRY_VOID(lines_.numbers(value, 1));
  return value[0];
}

// Reads up to three numbers from word `at` on, of which two are kept; returns where they end. The
// last word is the file's.
size_t MtlReader::read_vector(size_t at, glm::vec2& value) const {
  constexpr float kMost = 1e6f;
  for (int i = 0; i < 3 && at + 1 < lines_.words().size(); ++i, ++at) {
    const std::optional<float> number = number_of(lines_.words()[at]);
    if (!number) break;
    if (i < 2) value[i] = std::clamp(*number, -kMost, kMost);
  }
  return at;
}

// Reads the option at word `at`; returns where the next word is.
size_t MtlReader::read_option(size_t at, MtlMap& map) {
  const auto words = lines_.words();
  const std::string_view option = words[at];
  const std::string_view value = at + 1 < words.size() ? words[at + 1] : std::string_view();
  if (option == "-s") return read_vector(at + 1, map.uv.scale);
  if (option == "-o") return read_vector(at + 1, map.uv.offset);
  if (option == "-clamp") {
    map.clamp = value == "on";
  } else if (option == "-bm") {
    map.bump = number_of(value).value_or(1.0f);
  } else if (option == "-imfchan") {
    map.channel = value.empty() ? '\0' : value[0];
  } else {
    warnings_->add("materials: option " + in_quotes(option) + " of " + in_quotes(words[0]) +
                   " is not supported: drawn without it");
    if (option == "-mm") return at + 3;
    glm::vec2 ignored(0.0f);
    if (option == "-t") return read_vector(at + 1, ignored);
  }
  return at + 2;
}

std::optional<MtlMap> MtlReader::read_map() {
  MtlMap map;
  map.place = place();
  size_t at = 1;
  // What begins with a minus is an option, as long as a word is left for the file.
  while (at + 1 < lines_.words().size() && lines_.words()[at][0] == '-') at = read_option(at, map);
  map.file = lines_.rest_from(at);
  if (map.file.empty()) {
    warnings_->add("materials: " + in_quotes(lines_.words()[0]) + " without a file is left out");
    return std::nullopt;
  }
  return map;
}

}  // namespace

Result<std::vector<MtlMaterial>> read_mtl(std::string_view text, const std::string& file,
                                          Warnings& warnings) {
  return MtlReader(text, file, warnings).read();
}

}  // namespace lueur
