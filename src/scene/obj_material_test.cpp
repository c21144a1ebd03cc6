// SPDX-License-Identifier: MIT
// MTL materials and their textures.
#include <png.h>

#include <array>

#include "scene/obj_test_files.h"

namespace lueur {
namespace {

// An RGBA picture as PNG.
std::string png_of(uint32_t width, uint32_t height, const std::vector<uint8_t>& rgba) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = width;
  image.height = height;
  image.format = PNG_FORMAT_RGBA;
  png_alloc_size_t size = 0;
  png_image_write_to_memory(&image, nullptr, &size, 0, rgba.data(), 0, nullptr);
  std::string bytes(size, '\0');
  png_image_write_to_memory(&image, bytes.data(), &size, 0, rgba.data(), 0, nullptr);
  bytes.resize(size);
  return bytes;
}

std::array<int, 4> texel(const Texture& texture, uint32_t x, uint32_t y) {
  const uint8_t* rgba = texture.rgba.data() + (size_t{y} * texture.width + x) * 4;
  return {rgba[0], rgba[1], rgba[2], rgba[3]};
}

TEST_F(ObjTest, ColorsGlossAndEmission) {
  const Scene scene =
      with_material("newmtl m\nKd 0.1 0.2 0.3\nKs 0.4 0.5 0.6\nNs 42\nKe 17 12 4\nillum 2\n");
  ASSERT_EQ(scene.materials.size(), 1u);
  const Material& m = scene.materials[0];
  EXPECT_EQ(m.base_color, glm::vec4(0.1f, 0.2f, 0.3f, 1.0f));
  EXPECT_EQ(m.metallic, 0.0f);
  ASSERT_TRUE(m.phong);
  EXPECT_EQ(m.phong->color, glm::vec3(0.4f, 0.5f, 0.6f));
  EXPECT_EQ(m.phong->exponent, 42.0f);
  EXPECT_EQ(m.emission, glm::vec3(17, 12, 4));
  EXPECT_TRUE(m.double_sided);
  EXPECT_TRUE(scene.warnings.empty()) << scene.warnings[0];
}

TEST_F(ObjTest, WithoutGlossItIsDiffuse) {
  for (const char* mtl : {"newmtl m\nKd 1 1 1\n", "newmtl m\nKs 1 1 1\nNs 9\nillum 1\n",
                          "newmtl m\nKs 0 0 0\nNs 9\nillum 2\n"}) {
    const Scene scene = with_material(mtl);
    EXPECT_FALSE(scene.materials[0].phong) << mtl;
    EXPECT_EQ(scene.materials[0].specular, 0.0f) << mtl;
  }
}

TEST_F(ObjTest, PbrStatementsTakeThePlaceOfGloss) {
  const Scene scene = with_material("newmtl m\nKs 1 1 1\nNs 9\nPr 0.3\nPm 0.7\n");
  EXPECT_FALSE(scene.materials[0].phong);
  EXPECT_EQ(scene.materials[0].roughness, 0.3f);
  EXPECT_EQ(scene.materials[0].metallic, 0.7f);
  EXPECT_EQ(scene.materials[0].specular, 1.0f);
}

TEST_F(ObjTest, DissolveCutsOut) {
  Scene scene = with_material("newmtl m\nd 0.25\nTr 0.9\n");
  EXPECT_EQ(scene.materials[0].alpha_mode, AlphaMode::mask);
  EXPECT_EQ(scene.materials[0].base_color.a, 0.25f);
  EXPECT_TRUE(warns_of(scene, "not drawn"));
  scene = with_material("newmtl m\nTr 0.25\n");
  EXPECT_EQ(scene.materials[0].base_color.a, 0.75f);
  scene = with_material("newmtl m\nd 1\nTr 0\nTf 1 1 1\n");
  EXPECT_EQ(scene.materials[0].alpha_mode, AlphaMode::opaque);
  EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(ObjTest, MissingMaterialsAreDefaultOnes) {
  const Scene scene = loaded("mtllib no.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n");
  ASSERT_EQ(scene.materials.size(), 1u);
  EXPECT_EQ(scene.materials[0].base_color.r, 0.8f);
  EXPECT_TRUE(warns_of(scene, "'no.mtl' is missing"));
  EXPECT_TRUE(warns_of(with_material("newmtl other\nKd 1 1 1\n"), "'m' is in none"));
}

TEST_F(ObjTest, MapsAndTheirOptions) {
  write("a b.png", png_of(2, 1, {10, 20, 30, 255, 40, 50, 60, 255}));
  write("d.png", png_of(1, 2, {255, 255, 255, 255, 0, 0, 0, 255}));
  const Scene scene = with_material(
      "newmtl m\nmap_Kd -s 2 4 1 -o 0.5 0 -clamp on -blendu on a b.png\n"
      "map_d -s 2 4 1 -o 0.5 d.png\nmap_Ks a b.png\n");
  ASSERT_EQ(scene.textures.size(), 1u);
  const Texture& texture = scene.textures[0];
  EXPECT_EQ(texture.wrap_u, Wrap::clamp_to_edge);
  EXPECT_EQ(texture.width, 2u);
  EXPECT_EQ(texture.height, 2u);
  EXPECT_EQ(texel(texture, 1, 0), (std::array{40, 50, 60, 255}));
  EXPECT_EQ(texel(texture, 0, 1), (std::array{10, 20, 30, 0}));
  EXPECT_EQ(scene.materials[0].base_color, glm::vec4(1.0f));
  EXPECT_EQ(scene.materials[0].alpha_mode, AlphaMode::mask);
  // (0.25 0.75) times (2 4), plus (0.5 0), turned upside down.
  EXPECT_EQ(scene.meshes[0].vertices[0].uv, glm::vec2(1.0f, -2.0f));
  EXPECT_TRUE(warns_of(scene, "'-blendu'"));
  EXPECT_TRUE(warns_of(scene, "'map_Ks'"));
  EXPECT_FALSE(warns_of(scene, "different -s"));
}

TEST_F(ObjTest, RoughnessAndMetallicShareATexture) {
  write("r.png", png_of(1, 1, {100, 100, 100, 255}));
  write("m.png", png_of(1, 1, {1, 2, 200, 255}));
  const Scene scene = with_material("newmtl m\nmap_Pr r.png\nmap_Pm -imfchan b m.png\n");
  ASSERT_EQ(scene.textures.size(), 1u);
  EXPECT_EQ(scene.materials[0].metallic_roughness_texture, 0);
  EXPECT_EQ(texel(scene.textures[0], 0, 0)[1], 100);
  EXPECT_EQ(texel(scene.textures[0], 0, 0)[2], 200);
}

TEST_F(ObjTest, HeightsBecomeNormals) {
  // A ridge along v: rises by 0.2 a texel to the middle, in x; flat in y.
  std::vector<uint8_t> ridge;
  for (int y = 0; y < 2; ++y)
    for (const uint8_t h : std::array<uint8_t, 4>{0, 51, 102, 51})
      ridge.insert(ridge.end(), {h, h, h, 255});
  write("h.png", png_of(4, 2, ridge));
  const Scene scene = with_material("newmtl m\nbump -bm 5 h.png\n");
  ASSERT_EQ(scene.textures.size(), 1u);
  EXPECT_EQ(scene.materials[0].normal_texture, 0);
  // Slope 5 * 0.2 = 1: the normal is (-1 0 1)/sqrt(2), and (1 0 1)/sqrt(2) on the far side.
  EXPECT_NEAR(texel(scene.textures[0], 1, 0)[0], 255 * (0.5 - 0.5 * 0.70711), 1.0);
  EXPECT_NEAR(texel(scene.textures[0], 3, 0)[0], 255 * (0.5 + 0.5 * 0.70711), 1.0);
  EXPECT_NEAR(texel(scene.textures[0], 1, 0)[1], 127.5, 1.0);
  EXPECT_NEAR(texel(scene.textures[0], 2, 1)[2], 255, 1.0);
  // A coloured picture is a normal map already.
  write("h.png", png_of(1, 1, {128, 128, 255, 255}));
  EXPECT_EQ(texel(with_material("newmtl m\nmap_Bump h.png\n").textures[0], 0, 0)[2], 255);
}

TEST_F(ObjTest, HeightsRiseUpwards) {
  // Brighter towards the top of the picture, the way v points up: the normal leans down.
  std::vector<uint8_t> ramp;
  for (const uint8_t h : std::array<uint8_t, 3>{200, 100, 0})
    ramp.insert(ramp.end(), {h, h, h, 255});
  write("h.png", png_of(1, 3, ramp));
  const Scene scene = with_material("newmtl m\nbump -clamp on h.png\n");
  EXPECT_LT(texel(scene.textures[0], 0, 1)[1], 120);
}

}  // namespace
}  // namespace lueur
