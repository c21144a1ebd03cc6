// SPDX-License-Identifier: MIT
// SOL 3.2 and 3.3: the sum over the patches that rays of the punctual lights shine on, with and
// without what stands between. What the technique `indirect_lights` approximates: I_c and I_s.
#pragma once

#include <vector>

#include "reference/pass_sum.h"
#include "reference/reference.h"
#include "reference/world.h"

namespace lueur::reference {

class LightSum final : public PassSum {
 public:
  // Places Settings::spp lights, or somewhat fewer: rays that meet nothing make none.
  LightSum(const World& world, const Shot& shot, const Settings& settings);

  uint32_t items_per_pass() const override { return kSamplesPerPass; }
  uint32_t passes() const override;
  void begin_pass(uint32_t pass) override { pass_ = pass; }
  glm::vec3 at(const FirstHit& receiver, uint64_t& rays) const override;

 private:
  struct Patch {
    glm::vec3 position, normal_area;  // normal times area over pi
    float area_over_pi;
    glm::vec3 radiance;
  };
  const World& world_;
  std::vector<Patch> patches_;
  uint32_t pass_ = 0;
  bool is_blocked_;
  bool is_bounded_;
};

}  // namespace lueur::reference
