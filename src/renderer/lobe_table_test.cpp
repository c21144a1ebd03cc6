// SPDX-License-Identifier: MIT
#include "renderer/lobe_table.h"

#include <gtest/gtest.h>

#include "image/half.h"

namespace lueur {
namespace {

Material with_lobe(const PhongLobe& lobe) {
  Material material;
  material.phong = lobe;
  return material;
}

TEST(LobeTable, EachLobeAndEachShapeIsThereOnce) {
  const PhongLobe red{{1, 0, 0}, 8, -1, 1};
  PhongLobe blue = red, flat = red;
  blue.color = {0, 0, 1};
  flat.c_z = 0.5f;
  const std::vector<Material> materials{
      with_lobe(red), {}, with_lobe(blue), with_lobe(flat), with_lobe(red)};
  const LobeTable table = lobe_table(materials);
  EXPECT_EQ(table.of_material, (std::vector<uint32_t>{1, 0, 2, 3, 1}));
  ASSERT_EQ(table.lobes.size(), 3u);
  ASSERT_EQ(table.shapes.size(), 2u);
  EXPECT_EQ(table.lobes[1].color, glm::vec3(0, 0, 1));
  EXPECT_EQ(table.lobes[0].name, -1.0f);
  EXPECT_EQ(table.lobes[1].name, -1.0f);
  EXPECT_EQ(table.lobes[2].name, -2.0f);
  EXPECT_EQ(table.lobes[2].exponent, 8.0f);
  EXPECT_EQ(table.lobes[2].c_xy, -1.0f);
  EXPECT_EQ(table.lobes[2].c_z, 0.5f);
  EXPECT_EQ(table.shapes[1].exponent, 8.0f);
  EXPECT_EQ(table.shapes[1].c_xy, -1.0f);
  EXPECT_EQ(table.shapes[1].c_z, 0.5f);
  EXPECT_EQ(table.left_out, 0u);
}

TEST(LobeTable, WhatIsUnlitReflectsNothing) {
  Material unlit = with_lobe({});
  unlit.unlit = true;
  const LobeTable table = lobe_table(std::vector{unlit});
  EXPECT_EQ(table.of_material[0], 0u);
  EXPECT_EQ(table.left_out, 0u);
}

// Each shape's name is a half float of its own, also one more than the technique's, which counts
// from 2; what is beyond is a roughness.
TEST(LobeTable, NamesAreDifferentHalfFloats) {
  std::vector<Material> materials;
  for (int i = 0; i < 2050; ++i)
    materials.push_back(with_lobe({.exponent = static_cast<float>(1 + i)}));
  const LobeTable table = lobe_table(materials);
  EXPECT_EQ(table.shapes.size(), 2047u);
  EXPECT_EQ(table.left_out, 0u);
  for (size_t i = 0; i < table.lobes.size(); ++i) {
    const float name = table.lobes[i].name;
    if (i < table.shapes.size()) {
      ASSERT_EQ(name, -1.0f - static_cast<float>(i));
      ASSERT_EQ(table.shapes[i].exponent, table.lobes[i].exponent);
      ASSERT_EQ(float_from_half(half_from_float(1.0f - name)), 1.0f - name);
    } else {
      // alpha^2 = 2 / (n + 2).
      ASSERT_NEAR(name * name * name * name, 2.0f / (table.lobes[i].exponent + 2), 1e-6f);
    }
  }
}

TEST(LobeTable, LobesBeyondTheTableAreCounted) {
  std::vector<Material> materials;
  for (uint32_t i = 0; i < kMostCosineLobes + 3; ++i)
    materials.push_back(with_lobe({.color = glm::vec3(static_cast<float>(i))}));
  materials.push_back(materials.front());
  const LobeTable table = lobe_table(materials);
  EXPECT_EQ(table.lobes.size(), kMostCosineLobes);
  EXPECT_EQ(table.of_material[kMostCosineLobes - 1], kMostCosineLobes);
  EXPECT_EQ(table.of_material[kMostCosineLobes], 0u);
  EXPECT_EQ(table.of_material.back(), 1u);
  EXPECT_EQ(table.left_out, 3u);
}

// How g_buffer.frag keeps an index, and that other bits do not matter.
TEST(LobeTable, IndicesLieInTheMaterialsBits) {
  for (const uint32_t index : {0u, 1u, 255u, 256u, kMostCosineLobes - 1}) {
    for (const uint32_t other : {0u, kKeepsLight}) {
      const uint32_t bits = other | kHasCosineLobe | (index >> 8);
      const vec4 material(0, 0, static_cast<float>(index & 255u) / 255.0f,
                          static_cast<float>(bits) / 255.0f);
      EXPECT_TRUE(has_cosine_lobe(material));
      EXPECT_EQ(cosine_lobe_index(material), index);
      EXPECT_EQ(keeps_light(material), other != 0);
    }
  }
  EXPECT_FALSE(has_cosine_lobe(vec4(1, 1, 1, static_cast<float>(kKeepsLight) / 255.0f)));
}

}  // namespace
}  // namespace lueur
