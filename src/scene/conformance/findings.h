// SPDX-License-Identifier: MIT
// What a check of a file found, as lines for the user; a file cannot make the list long.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lueur::conformance {

class Findings {
 public:
  static constexpr size_t kMaxLines = 16;

  // "path: what". `path` is a JSON path such as "meshes[3].primitives[0].mode", or empty.
  void add(const std::string& path, std::string_view what);

  // The lines, and one more that counts what did not fit.
  std::vector<std::string> take();

 private:
  std::vector<std::string> lines_;
  size_t left_out_ = 0;
};

}  // namespace lueur::conformance
