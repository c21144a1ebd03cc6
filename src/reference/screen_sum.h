// SPDX-License-Identifier: MIT
// HSSIL (3) or (4) over the camera's pixels, with visibility 1: what a gather on the screen
// estimates. Errors beyond this are sampling and filtering.
#pragma once

#include <vector>

#include "reference/camera.h"
#include "reference/pass_sum.h"
#include "reference/reference.h"

namespace lueur::reference {

class ScreenSum final : public PassSum {
 public:
  // Pixels that one pass sums up.
  static constexpr uint32_t kPixelsPerPass = 256;

  // `hits` are those of all pixels, row by row, `source` their layer.
  ScreenSum(const std::vector<std::optional<FirstHit>>& hits, const ImageF& source,
            const PinholeCamera& camera, const Settings& settings);

  uint32_t items_per_pass() const override { return kPixelsPerPass; }
  uint32_t passes() const override { return passes_; }  // of the pixels that have light
  void begin_pass(uint32_t pass) override;
  glm::vec3 at(const FirstHit& receiver, uint64_t& rays) const override;

 private:
  // A source pixel: place, normal, area over pi, radiance.
  struct Source {
    glm::vec3 position, normal;
    float area_over_pi;
    glm::vec3 radiance;
  };
  // The pixels of a pass, a row each, so that several are summed at once; the rest of the last ones
  // are black.
  struct Chosen {
    alignas(64) float x[kPixelsPerPass], y[kPixelsPerPass], z[kPixelsPerPass];
    float normal_x[kPixelsPerPass], normal_y[kPixelsPerPass], normal_z[kPixelsPerPass];
    float area_over_pi[kPixelsPerPass];
    float red[kPixelsPerPass], green[kPixelsPerPass], blue[kPixelsPerPass];
  };
  template <class Factor>
  static glm::vec3 sum(const Chosen& chosen, const FirstHit& receiver, Factor factor);

  std::vector<Source> sources_;
  Chosen chosen_{};
  uint32_t passes_ = 0;
  uint32_t seed_ = 0;
  FormFactor form_factor_;
};

}  // namespace lueur::reference
