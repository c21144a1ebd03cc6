// SPDX-License-Identifier: MIT
// Makes one header readable as C++ and as GLSL. In C++ the vector types are glm's; their natural
// layout is GLSL's `scalar` layout, so a structure needs neither alignas nor padding members. Rules
// for shared structures: no bool, no default values, no pointers.
#ifndef LUEUR_SHADING_GPU_H
#define LUEUR_SHADING_GPU_H

#ifdef __cplusplus

#include <cstdint>
#include <glm/glm.hpp>

#define LUEUR_NAMESPACE_BEGIN namespace lueur {
#define LUEUR_NAMESPACE_END }
// A function that both languages compile.
#define LUEUR_SHARED inline

namespace lueur {
// The functions that shared code calls, as GLSL spells them.
using glm::abs;
using glm::atan;
using glm::ceil;
using glm::clamp;
using glm::cos;
using glm::cross;
using glm::dot;
using glm::exp;
using glm::floor;
using glm::fract;
using glm::inversesqrt;
using glm::length;
using glm::log;
using glm::max;
using glm::min;
using glm::mix;
using glm::normalize;
using glm::pow;
using glm::sin;
using glm::sqrt;

using glm::ivec2;
using glm::ivec4;
using glm::mat2;
using glm::mat3;
using glm::mat4;
using glm::uvec2;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using uint = uint32_t;  // NOLINT(readability-identifier-naming): GLSL's name
}  // namespace lueur

#else

#define LUEUR_NAMESPACE_BEGIN
#define LUEUR_NAMESPACE_END
#define LUEUR_SHARED

#endif

#endif
