// SPDX-License-Identifier: MIT
#include "scene/conformance/findings.h"

#include <algorithm>
#include <utility>

namespace lueur::conformance {

void Findings::add(const std::string& path, std::string_view what) {
  if (lines_.size() >= kMaxLines) {
    ++left_out_;
    return;
  }
  std::string line = path;
  if (!path.empty()) line += ": ";
  line += what;
  if (std::find(lines_.begin(), lines_.end(), line) == lines_.end())
    lines_.push_back(std::move(line));
}

std::vector<std::string> Findings::take() {
  if (left_out_ > 0)
    lines_.push_back("the file breaks the rules of glTF in " + std::to_string(left_out_) +
                     " more places");
  return std::move(lines_);
}

}  // namespace lueur::conformance
