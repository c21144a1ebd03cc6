// SPDX-License-Identifier: MIT
// FDP figure 3, left and right: where `hierarchical` takes its samples, by the technique's own
// formulas. No device is needed.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "image/image.h"
#include "lueur/hierarchical.h"

namespace lueur::cli::fdp {

// Where a pixel of level `level` (0: the finest) takes its samples, in pixels of the level; outside
// of the image, too.
std::vector<glm::ivec2> sample_pixels(const HierarchicalSettings& settings, uint32_t level,
                                      glm::ivec2 pixel, uint32_t seed);

// Which pixels of an image take part in the light of its pixel `receiver`, once all levels are
// filtered, up-sampled and added: 0 for none, else 1 + the finest level at which one is sampled.
// Row by row. Without regard to surfaces: on one smooth surface all of these do.
std::vector<uint8_t> participating_pixels(const HierarchicalSettings& settings, Extent extent,
                                          glm::ivec2 receiver, uint32_t seed);

// Drawings of the two: a ring enlarged, its borders in grey; the image, with the receiver marked.
Image8 draw_samples(const HierarchicalSettings& settings, uint32_t level, uint32_t seed);
Image8 draw_participants(const HierarchicalSettings& settings, Extent extent, uint32_t seed);

}  // namespace lueur::cli::fdp
