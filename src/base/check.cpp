// SPDX-License-Identifier: MIT
#include "base/check.h"

#include <cstdio>
#include <cstdlib>

namespace lueur {

void check_failed(const char* file, int line, const char* text, const std::string& operands) {
  std::fprintf(stderr, "%s:%d: broken promise: %s%s%s\n", file, line, text,
               operands.empty() ? "" : " with ", operands.c_str());
  std::abort();
}

}  // namespace lueur
