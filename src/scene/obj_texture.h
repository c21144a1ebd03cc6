// SPDX-License-Identifier: MIT
// The textures that the materials of an OBJ file ask for: read from beside it, decoded together,
// and made into the ones that a Material knows.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "lueur/result.h"
#include "scene/mtl_read.h"
#include "scene/scene.h"
#include "scene/texture_decode.h"
#include "scene/warnings.h"

namespace lueur {

class ObjTextures {
 public:
  // Files are read from `folder` and below it; all together, with the `bytes_read` so far, within
  // `limits`, which must outlive this.
  ObjTextures(std::filesystem::path folder, const LoadLimits& limits, uint64_t bytes_read,
              Warnings& warnings)
      : folder_(std::move(folder)),
        limits_(&limits),
        bytes_read_(bytes_read),
        warnings_(&warnings) {}

  // Each notes a texture and returns its place in Scene::textures; kNone where the picture is
  // missing or outside the folder, with a warning. Fails on pictures beyond the limits.
  Result<int32_t> picture(const MtlMap& map);
  // The picture's colours with the alpha of another one; `color` may be null for white.
  Result<int32_t> cut_out(const MtlMap* color, const MtlMap& alpha);
  // Green and blue as glTF has them; one of the two may be null for white.
  Result<int32_t> metallic_roughness(const MtlMap* roughness, const MtlMap* metallic);
  // A picture of greys is a map of heights, of which 1 is as high as `bump` texels are wide; any
  // other one is a normal map, as many files put one here.
  Result<int32_t> bumps(const MtlMap& map);

  // Decodes and makes all that were noted.
  Result<std::vector<Texture>> make();

 private:
  enum class Kind : uint8_t { picture, cut_out, metallic_roughness, bumps };
  struct Recipe {
    Kind kind = Kind::picture;
    int32_t first = kNone, second = kNone;  // in images_
    char first_channel = 0, second_channel = 0;
    bool clamp = false;
    float bump = 1.0f;
    auto operator<=>(const Recipe&) const = default;
  };
  Result<int32_t> image(const MtlMap& map);
  Result<int32_t> note(const Recipe& recipe);
  Texture made(const Recipe& recipe) const;

  std::filesystem::path folder_;
  const LoadLimits* limits_;
  uint64_t bytes_read_;
  Warnings* warnings_;
  uint64_t pixel_bytes_ = 0;
  std::vector<EncodedImage> images_;
  std::map<std::string, int32_t> image_of_file_;  // kNone: it cannot be used
  std::vector<Recipe> recipes_;
  std::map<Recipe, int32_t> place_of_recipe_;
};

}  // namespace lueur
