// SPDX-License-Identifier: MIT
#include "scene/warnings.h"

#include <algorithm>

namespace lueur {

void Warnings::add(const std::string& line) {
  constexpr size_t kMaxLines = 64;
  if (lines_.size() >= kMaxLines) return;
  if (std::find(lines_.begin(), lines_.end(), line) == lines_.end()) lines_.push_back(line);
}

}  // namespace lueur
