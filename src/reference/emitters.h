// SPDX-License-Identifier: MIT
// Triangles that glow, as lights to take samples of.
#pragma once

#include <optional>
#include <vector>

#include "reference/world.h"

namespace lueur::reference {

// They shine on both sides, as every surface has two for light.
class Emitters {
 public:
  explicit Emitters(const World& world);
  bool empty() const { return entries_.empty(); }

  struct Sample {
    glm::vec3 position{0.0f};
    glm::vec3 normal{0.0f};    // unit, geometric, on the front side
    glm::vec3 radiance{0.0f};  // emitted
    float pdf_area = 0;        // per square metre
    uint32_t part = 0;
  };
  // A triangle in proportion to its power and a point evenly on it. Not when empty().
  Sample sample(float choice, glm::vec2 u) const;
  // The density per square metre with which sample() finds a point of this part.
  float pdf_area(uint32_t part) const { return density_of_part_[part]; }

 private:
  struct Entry {
    uint32_t part, triangle;
    float cumulative;  // share of the power up to and with this one
  };
  const World* world_;
  std::vector<Entry> entries_;
  std::vector<float> density_of_part_;  // power / (area * total power), by part
};

}  // namespace lueur::reference
