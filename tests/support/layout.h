// SPDX-License-Identifier: MIT
// Holds a structure shared by C++ and GLSL against what the shader's reflection says of it.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <initializer_list>
#include <utility>

#include "gpu/shader.h"

namespace lueur {

// `block`: "push" for push constants, else the binding's name. `members`: every member in order,
// with its offset in C++.
inline void expect_layout(const gpu::ShaderCode& code, const std::string& block, size_t cpp_bytes,
                          std::initializer_list<std::pair<const char*, size_t>> members) {
  SCOPED_TRACE(std::string(code.name) + " " + block);
  const auto interface = gpu::reflect(code);
  ASSERT_TRUE(interface.ok());
  std::vector<gpu::ShaderMember> found;
  if (block == "push") {
    found = interface->push_constants;
    EXPECT_EQ(interface->push_constant_bytes, cpp_bytes);
  } else {
    for (const auto& [name, block_members] : interface->blocks)
      if (name == block) found = block_members;
  }
  ASSERT_EQ(found.size(), members.size());
  size_t i = 0;
  for (const auto& [name, offset] : members) {
    EXPECT_EQ(found[i].name, name);
    EXPECT_EQ(found[i].offset, offset) << name;
    ++i;
  }
  if (!found.empty()) {
    EXPECT_LE(found.back().offset + found.back().bytes, cpp_bytes);
  }
}

}  // namespace lueur

#define LUEUR_MEMBER(type, member)  \
  std::pair<const char*, size_t> {  \
#member, offsetof(type, member) \
  }
