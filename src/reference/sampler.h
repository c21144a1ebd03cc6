// SPDX-License-Identifier: MIT
// Random numbers that fill their space evenly: the first two dimensions of Sobol's sequence, once
// for each pair of numbers a path needs, each with an Owen scrambling and an order of its own.
//
//   B. Burley: "Practical Hash-Based Owen Scrambling", JCGT 9(4), 2020.
//
// Every aligned power of two of indices is stratified in each pair, and any prefix is nearly so.
// Scramblings of different seeds are independent, so estimates over seeds scatter around the truth.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

namespace lueur::reference {

// A good mix of 32 bits: each bit of the input flips half of the output.
constexpr uint32_t mixed(uint32_t x) {
  x ^= x >> 16;
  x *= 0x21f0aaadu;
  x ^= x >> 15;
  x *= 0xd35a2d97u;
  x ^= x >> 15;
  return x;
}

constexpr uint32_t combined(uint32_t a, uint32_t b) {
  return mixed(a ^ mixed(b + 0x9e3779b9u));
}

namespace detail {

constexpr uint32_t reversed(uint32_t x) {
  x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
  x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
  x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
  return __builtin_bswap32(x);
}

// Owen's nested scrambling of reversed bits: each bit is flipped by a hash of those below it.
constexpr uint32_t scrambled_reversed(uint32_t x, uint32_t seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

constexpr uint32_t scrambled(uint32_t x, uint32_t seed) {
  return reversed(scrambled_reversed(reversed(x), seed));
}

// Sobol's second dimension, a byte of the index at a time.
constexpr std::array<std::array<uint32_t, 256>, 4> make_sobol_table() {
  std::array<uint32_t, 32> column{};
  uint32_t v = 1u << 31;
  for (uint32_t& c : column) {
    c = v;
    v ^= v >> 1;
  }
  std::array<std::array<uint32_t, 256>, 4> table{};
  for (uint32_t byte = 0; byte < 4; ++byte)
    for (uint32_t value = 0; value < 256; ++value)
      for (uint32_t bit = 0; bit < 8; ++bit)
        if ((value >> bit) & 1u) table[byte][value] ^= column[8 * byte + bit];
  return table;
}
inline constexpr auto kSobolSecond = make_sobol_table();

constexpr uint32_t sobol_second(uint32_t i) {
  return kSobolSecond[0][i & 255u] ^ kSobolSecond[1][(i >> 8) & 255u] ^
         kSobolSecond[2][(i >> 16) & 255u] ^ kSobolSecond[3][i >> 24];
}

}  // namespace detail

// Uniform in [0, 1).
constexpr float unit_float(uint32_t bits) {
  return static_cast<float>(bits >> 8) * 0x1p-24f;
}

// The numbers of one sample of one pixel, in the order in which they are asked for.
class Sampler {
 public:
  Sampler(uint32_t pixel_seed, uint32_t index) : seed_(pixel_seed), index_(index) {}

  glm::vec2 next_2d() {
    const uint32_t seed = combined(seed_, dimension_++);
    const uint32_t i = detail::scrambled(index_, seed);
    const uint32_t x = detail::scrambled(detail::reversed(i), mixed(seed ^ 0x68bc21ebu));
    const uint32_t y = detail::scrambled(detail::sobol_second(i), mixed(seed ^ 0x02e5be93u));
    return {unit_float(x), unit_float(y)};
  }
  float next() { return next_2d().x; }

 private:
  uint32_t seed_;
  uint32_t index_;
  uint32_t dimension_ = 0;
};

}  // namespace lueur::reference
