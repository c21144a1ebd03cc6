// SPDX-License-Identifier: MIT
// Light as a finite sum over things that shine, a part of them in each pass.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

#include "reference/first_hits.h"

namespace lueur::reference {

class PassSum {
 public:
  virtual ~PassSum() = default;
  virtual uint32_t items_per_pass() const = 0;
  // Passes after which everything was summed once.
  virtual uint32_t passes() const = 0;
  // Chooses what pass `pass` sums; the choices lie evenly among all, and so do those of a row of
  // passes.
  virtual void begin_pass(uint32_t pass) = 0;
  // diffuse, estimated from this pass; the mean over all passes is the whole sum. Adds the rays
  // that it traces to `rays`.
  virtual glm::vec3 at(const FirstHit& receiver, uint64_t& rays) const = 0;
};

}  // namespace lueur::reference
