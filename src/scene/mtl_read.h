// SPDX-License-Identifier: MIT
// The statements of an MTL file, as they stand there.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lueur/result.h"
#include "scene/obj_geometry.h"
#include "scene/warnings.h"

namespace lueur {

// A picture that a statement names, with those of its options that are read.
struct MtlMap {
  std::string file;   // as written
  std::string place;  // "file: line 12", for messages
  UvTransform uv;     // -s, -o
  bool clamp = false;
  float bump = 1.0f;  // -bm
  char channel = 0;   // -imfchan: r g b m l z; 0: not told
};

// What is not there was not told. Numbers are finite, but not yet in range.
struct MtlMaterial {
  std::string name;
  std::string place;                                              // "file: line 12", for messages
  std::optional<glm::vec3> diffuse, specular, emission;           // Kd Ks Ke
  std::optional<float> shininess, dissolve, roughness, metallic;  // Ns d Pr Pm
  std::optional<MtlMap> diffuse_map, emission_map, dissolve_map;  // map_Kd map_Ke map_d
  std::optional<MtlMap> bump_map, normal_map;                     // bump norm
  std::optional<MtlMap> roughness_map, metallic_map;              // map_Pr map_Pm
  bool is_clear = false;                                          // Tf or illum ask for refraction
  bool has_gloss = true;                                          // illum 0 and 1 leave Ks out
};

// Fails on malformed numbers; statements and options that are not read are warned of.
Result<std::vector<MtlMaterial>> read_mtl(std::string_view text, const std::string& file,
                                          Warnings& warnings);

}  // namespace lueur
