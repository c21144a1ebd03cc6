// SPDX-License-Identifier: MIT
// Textures made by formulas; all repeat without a seam.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <string>

#include "scene/scene.h"

namespace lueur::builtin {

// A number in [0, 1) that depends on nothing but its arguments.
float hash_unit(uint32_t x, uint32_t y, uint32_t seed);

// Smooth noise in [0, 1] of `octaves` octaves over [0, 1)², periodic; the first has `cells` cells.
float tiling_noise(glm::vec2 uv, int cells, int octaves, uint32_t seed);

// `albedo(uv)` is linear Rec.709 in [0, 1]; uv in [0, 1), from the top left.
Texture make_color_texture(std::string name, uint32_t size,
                           const std::function<glm::vec3(glm::vec2 uv)>& albedo);

// The normals of the height field `height_m(uv)`, where one repeat is `size_m` metres wide.
Texture make_normal_texture(std::string name, uint32_t size, float size_m,
                            const std::function<float(glm::vec2 uv)>& height_m);

// A surface pattern: what it looks like and how it stands out.
struct Pattern {
  std::function<glm::vec3(glm::vec2 uv)> albedo;
  std::function<float(glm::vec2 uv)> height_m;
};
Pattern pavement_pattern();   // 4 x 4 slabs, two tones
Pattern masonry_pattern();    // four courses of two blocks each, staggered
Pattern limestone_pattern();  // plain stone with soft clouds
Pattern cloth_pattern();      // plain weave, near white: coloured by the material
Pattern wood_pattern();       // six upright planks
Pattern old_stone_pattern();  // grey, streaked by rain, with spots of lichen
Pattern clay_pattern();       // fired clay, mottled: for bricks that are solids themselves
Pattern earth_pattern();      // soil with moss and fallen leaves
Pattern bark_pattern();       // furrowed, upright
Pattern terrazzo_pattern();   // chips of pale and coloured stone in cement, polished flat

// Adds both textures of `pattern` to `scene` and binds them to `material`.
void bind_pattern(Scene& scene, int32_t material, const std::string& name, uint32_t size,
                  float size_m, const Pattern& pattern);

}  // namespace lueur::builtin
