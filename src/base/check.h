// SPDX-License-Identifier: MIT
// A promise of our own code. When it is broken the program is wrong: both operands are printed and
// it stops. What a user, a file or a device can cause is never checked this way; see
// lueur/result.h.
#pragma once

#include <sstream>
#include <string>

namespace lueur {

[[noreturn]] void check_failed(const char* file, int line, const char* text,
                               const std::string& operands);

template <class A, class B>
std::string describe_operands(const A& a, const B& b) {
  std::ostringstream out;
  out << a << " and " << b;
  return out.str();
}

}  // namespace lueur

#define LUEUR_CHECK(condition) \
  ((condition) ? void() : ::lueur::check_failed(__FILE__, __LINE__, #condition, ""))

#define LUEUR_CHECK_OP(a, op, b)                                             \
  (((a)op(b)) ? void()                                                       \
              : ::lueur::check_failed(__FILE__, __LINE__, #a " " #op " " #b, \
                                      ::lueur::describe_operands((a), (b))))
