// SPDX-License-Identifier: MIT
// Sums of whole passes: a rendering can stop after any of them and go on later to the same bits.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "image/image.h"
#include "lueur/result.h"
#include "reference/light_paths.h"

namespace lueur::reference {

class Accumulator {
 public:
  Accumulator(uint32_t width, uint32_t height);

  // The mean of one pass's samples, for each pixel, row by row.
  void add_pass(const std::vector<PathSample>& means);
  uint32_t passes() const { return passes_; }

  ImageF diffuse() const;
  ImageF specular() const;
  // Of the mean of diffuse, by how passes differ; 0 before the second pass.
  ImageF variance() const;
  // Progress::relative_error.
  double relative_error() const;

  // Bytes that from_bytes() makes the same accumulator of. `key` names what was rendered.
  std::vector<uint8_t> to_bytes(const std::string& key) const;
  // Fails (ErrorKind::input) on bytes that are damaged, or of another key or size.
  Result<void> from_bytes(std::span<const uint8_t> bytes, const std::string& key);

 private:
  struct Sums {
    double diffuse[3] = {};
    double diffuse_squared[3] = {};
    double specular[3] = {};
  };
  ImageF mean_of(const double (Sums::*sums)[3]) const;
  double variance_of(const Sums& sums, int channel) const;

  uint32_t width_, height_;
  uint32_t passes_ = 0;
  std::vector<Sums> pixels_;
};

}  // namespace lueur::reference
