// SPDX-License-Identifier: MIT
// What a reader has to tell about a file that it could use.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace lueur {

// One line each, each line once; a file cannot make the list long.
class Warnings {
 public:
  void add(const std::string& line);
  std::vector<std::string> take() { return std::move(lines_); }

 private:
  std::vector<std::string> lines_;
};

}  // namespace lueur
