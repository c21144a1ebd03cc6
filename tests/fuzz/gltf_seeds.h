// SPDX-License-Identifier: MIT
// Small glTF files, text with all data inside, that between them use each feature of the loader.
#pragma once

#include <string>
#include <vector>

namespace lueur {

struct GltfSeed {
  std::string name;
  std::string text;
};

// `png`: the bytes of a picture, for those that have textures.
std::vector<GltfSeed> gltf_seeds(const std::string& png);

}  // namespace lueur
