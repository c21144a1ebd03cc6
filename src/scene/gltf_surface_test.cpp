// SPDX-License-Identifier: MIT
// Vertex colours, texture coordinates, compressed and sparse data, and materials of other models.
#include <meshoptimizer.h>

#include <cmath>

#include "scene/gltf_export.h"
#include "scene/gltf_test_files.h"
#include "scene/specular_glossiness.h"

namespace lueur {
namespace {

// The triangle with more attributes: `accessors` and `views` are appended, over buffer 1.
std::string triangle_with(const std::string& attributes, const std::string& bytes,
                          const std::string& views, const std::string& accessors) {
  std::string json =
      with(triangle_json(), R"({"POSITION":0})", R"({"POSITION":0,)" + attributes + "}");
  json = with(json, R"(}],
"bufferViews")",
              R"(},{"byteLength":)" + std::to_string(bytes.size()) + R"(,"uri":")" +
                  data_uri(bytes) + R"("}],
"bufferViews")");
  json = with(json, R"("byteLength":6}])", R"("byteLength":6},)" + views + "]");
  return with(json, R"("count":3,"type":"SCALAR"}])",
              R"("count":3,"type":"SCALAR"},)" + accessors + "]");
}

TEST_F(GltfTest, VertexColoursOfAnyTypeAreRead) {
  const std::string view = R"({"buffer":1,"byteLength":%})";
  const auto floats = load(triangle_with(
      R"("COLOR_0":2)", bytes_of<float>({0, 0.5f, 1, 1, 0.25f, 0, 2, -1, 0.125f}),
      with(view, "%", "36"), R"({"bufferView":2,"componentType":5126,"count":3,"type":"VEC3"})"));
  ASSERT_TRUE(floats.ok()) << floats.error().message;
  const auto color = [](const Scene& scene, size_t i) {
    return color_of(scene.meshes[0].vertices[i]);
  };
  EXPECT_LT(glm::distance(color(*floats, 0), glm::vec4(0, 0.5f, 1, 1)), 1e-4f);
  // Beyond 0 to 1 they are clamped.
  EXPECT_LT(glm::distance(color(*floats, 2), glm::vec4(1, 0, 0.125f, 1)), 1e-4f);

  const auto bytes = load(triangle_with(
      R"("COLOR_0":2)", bytes_of<uint8_t>({255, 0, 51, 102, 0, 0, 0, 0, 1, 2, 3, 4}),
      with(view, "%", "12"),
      R"({"bufferView":2,"componentType":5121,"normalized":true,"count":3,"type":"VEC4"})"));
  ASSERT_TRUE(bytes.ok()) << bytes.error().message;
  EXPECT_LT(glm::distance(color(*bytes, 0), glm::vec4(1, 0, 0.2f, 0.4f)), 1e-4f);
  EXPECT_EQ(color_of(load(triangle_json())->meshes[0].vertices[0]), glm::vec4(1.0f));
}

constexpr const char* kPixel =
    "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAQAAAC1HAwCAAAAC0lEQVR42mP8/x8AAwMCAO+"
    "ip1sAAAAASUVORK5CYII=";

// A material whose base colour uses TEXCOORD_3 and whose normal map TEXCOORD_1.
std::string two_sets_json(const std::string& base_color, const std::string& normal) {
  const std::string bytes =
      bytes_of<float>({0, 1, 2, 3, 4, 5}) + bytes_of<float>({6, 7, 8, 9, 1, 2});
  std::string json =
      triangle_with(R"("TEXCOORD_1":2,"TEXCOORD_3":3)", bytes,
                    R"({"buffer":1,"byteLength":24},{"buffer":1,"byteOffset":24,"byteLength":24})",
                    R"({"bufferView":2,"componentType":5126,"count":3,"type":"VEC2"},
{"bufferView":3,"componentType":5126,"count":3,"type":"VEC2"})");
  json = with(json, R"("indices":1)", R"("indices":1,"material":0)");
  return with(json, R"("buffers":)",
              R"("materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0)" +
                  base_color + R"(}},"normalTexture":{"index":0)" + normal + R"(}}],
"textures":[{"source":0}],"images":[{"uri":")" +
                  kPixel + R"("}],"buffers":)");
}

TEST_F(GltfTest, EachTextureHasItsOwnCoordinates) {
  const auto scene = load(two_sets_json(R"(,"texCoord":3)", R"(,"texCoord":1)"));
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  const Material& material = scene->materials[0];
  // Tangents follow the first set: it is the normal map's.
  EXPECT_EQ(material.normal_texture.uv_set, 0u);
  EXPECT_EQ(material.base_color_texture.uv_set, 1u);
  EXPECT_EQ(scene->meshes[0].vertices[1].uv, glm::vec2(2, 3));
  EXPECT_EQ(scene->meshes[0].vertices[1].uv_2, glm::vec2(8, 9));
  for (const std::string& warning : scene->warnings)
    EXPECT_EQ(warning.find("more than two sets"), std::string::npos) << warning;
}

TEST_F(GltfTest, TexturesWithoutAnImageUseNoCoordinates) {
  const auto scene = load(with(two_sets_json(R"(,"texCoord":3)", ""), R"({"source":0})", "{}"));
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  EXPECT_FALSE(scene->materials[0].base_color_texture.is_used());
  EXPECT_EQ(scene->materials[0].base_color_texture.uv_set, 0u);
}

TEST_F(GltfTest, TextureTransformsScaleThenTurnThenMove) {
  const auto scene = load(two_sets_json(
      R"(,"texCoord":3,"extensions":{"KHR_texture_transform":
{"offset":[0.5,0.25],"rotation":1.57079633,"scale":[2,3],"texCoord":1}})",
      R"(,"texCoord":1)"));
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  const TextureUse& use = scene->materials[0].base_color_texture;
  EXPECT_EQ(use.uv_set, 0u);  // the extension's set
  // A quarter turn, counter-clockwise where v points down, takes u to -v and v to u.
  const glm::vec2 at = texture_place(use, {0.1f, 0.2f}, {9, 9});
  EXPECT_LT(glm::distance(at, glm::vec2(0.5f + 0.6f, 0.25f - 0.2f)), 1e-6f);
  EXPECT_EQ(texture_place(scene->materials[0].normal_texture, {0.1f, 0.2f}, {9, 9}),
            glm::vec2(0.1f, 0.2f));
}

TEST_F(GltfTest, ExportKeepsColoursSetsAndTransforms) {
  auto scene = load(two_sets_json(
      R"(,"texCoord":3,"extensions":{"KHR_texture_transform":
{"offset":[0.5,0.25],"rotation":0.7,"scale":[2,-3]}})",
      R"(,"texCoord":1)"));
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  scene->meshes[0].vertices[1].color = {1, 2, 3, 40000};
  scene->materials[0].unlit = true;
  const auto path = folder_ / "asset" / "out.glb";
  ASSERT_TRUE(export_glb(*scene, path).ok());
  const auto again = load_gltf(path);
  ASSERT_TRUE(again.ok()) << again.error().message;
  EXPECT_TRUE(again->warnings.empty());
  EXPECT_TRUE(again->materials[0].unlit);
  EXPECT_EQ(again->meshes[0].vertices[1].color, scene->meshes[0].vertices[1].color);
  const TextureUse &want = scene->materials[0].base_color_texture,
                   &got = again->materials[0].base_color_texture;
  const Vertex &w = scene->meshes[0].vertices[2], &g = again->meshes[0].vertices[2];
  EXPECT_LT(glm::distance(texture_place(got, g.uv, g.uv_2), texture_place(want, w.uv, w.uv_2)),
            1e-5f);
}

TEST_F(GltfTest, SparseIndicesAreRead) {
  // Indices without a view are zeros, of which the sparse part sets the last two.
  const std::string bytes = bytes_of<uint16_t>({1, 2}) + bytes_of<uint16_t>({2, 1});
  std::string json =
      triangle_with(R"("NORMAL":0)", bytes,
                    R"({"buffer":1,"byteLength":4},
{"buffer":1,"byteOffset":4,"byteLength":4})",
                    R"({"componentType":5123,"count":3,"type":"SCALAR","sparse":{"count":2,
"indices":{"bufferView":2,"componentType":5123},"values":{"bufferView":3}}})");
  json = with(json, R"("indices":1)", R"("indices":2)");
  const auto scene = load(json);
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  EXPECT_EQ(scene->meshes[0].indices, (std::vector<uint32_t>{0, 2, 1}));
}

// The triangle's positions, packed by the encoder that exporters use.
std::string packed_positions() {
  const std::string raw = bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0});
  std::string packed(meshopt_encodeVertexBufferBound(3, 12), '\0');
  packed.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(packed.data()),
                                           packed.size(), raw.data(), 3, 12));
  return packed;
}

std::string packed_json(const std::string& packed, const std::string& rest) {
  std::string json = with(triangle_json(), R"(}],
"bufferViews")",
                          R"(},{"byteLength":)" + std::to_string(packed.size()) + R"(,"uri":")" +
                              data_uri(packed) + R"("},{"byteLength":36}],
"bufferViews")");
  return with(
      json, R"({"buffer":0,"byteLength":36})",
      R"({"buffer":2,"byteLength":36,"byteStride":12,"extensions":{"EXT_meshopt_compression":
{"buffer":1,"byteLength":)" +
          std::to_string(packed.size()) + "," + rest + "}}}");
}

TEST_F(GltfTest, MeshoptViewsAreUnpacked) {
  const std::string sound = R"("byteStride":12,"count":3,"mode":"ATTRIBUTES")";
  const auto scene = load(packed_json(packed_positions(), sound));
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  EXPECT_EQ(scene->meshes[0].vertices[1].position, glm::vec3(1, 0, 0));
  EXPECT_EQ(scene->meshes[0].vertices[2].position, glm::vec3(0, 1, 0));

  std::string cut = packed_positions();
  cut.resize(cut.size() / 2);
  expect_refused(packed_json(cut, sound), {"bufferViews[0]", "damaged"});
  expect_refused(packed_json(packed_positions(), with(sound, "12", "10")),
                 {"EXT_meshopt_compression.byteStride", "does not fit"});
  expect_refused(packed_json(packed_positions(), with(sound, ":3", ":90000000000")),
                 {"EXT_meshopt_compression.count", "limit"});
  expect_refused(packed_json(packed_positions(), with(sound, "ATTRIBUTES", "ANY")),
                 {"EXT_meshopt_compression.mode", "'ANY'"});
}

TEST(SpecularGlossiness, GivesBackTheSurfaceItWasMadeFrom) {
  for (const float metallic : {0.0f, 0.3f, 0.8f, 1.0f}) {
    const glm::vec3 base(0.7f, 0.4f, 0.2f);
    const glm::vec3 f0 = glm::mix(glm::vec3(0.04f), base, metallic);
    const float strongest = std::max({f0.x, f0.y, f0.z});
    const glm::vec3 diffuse = base * (1.0f - metallic) / (1.0f - strongest);
    const MetallicRoughness found = metallic_roughness_of(diffuse, f0);
    EXPECT_NEAR(found.metallic, metallic, 1e-4f);
    EXPECT_LT(glm::distance(found.base_color, base), 1e-4f) << metallic;
  }
  // Less than a dielectric reflects: the share of its 0.04.
  EXPECT_NEAR(metallic_roughness_of(glm::vec3(0.5f), glm::vec3(0.01f)).specular, 0.25f, 1e-6f);
}

TEST_F(GltfTest, SpecularGlossinessIsConverted) {
  const std::string json =
      with(with(triangle_json(), R"("indices":1)", R"("indices":1,"material":0)"), R"("buffers":)",
           R"("materials":[{"extensions":{"KHR_materials_pbrSpecularGlossiness":
{"diffuseFactor":[0.5,0.5,0.5,0.25],"specularFactor":[0.04,0.04,0.04],"glossinessFactor":0.75}}}],
"buffers":)");
  const auto scene = load(json);
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  const Material& material = scene->materials[0];
  EXPECT_NEAR(material.base_color.x, 0.5f * 0.96f, 1e-6f);
  EXPECT_EQ(material.base_color.w, 0.25f);
  EXPECT_EQ(material.metallic, 0.0f);
  EXPECT_EQ(material.roughness, 0.25f);

  const auto textured =
      load(with(with(json, R"("diffuseFactor")",
                     R"("specularGlossinessTexture":{"index":0},"diffuseFactor")"),
                R"("buffers":)",
                std::string(R"("textures":[{"source":0}],"images":[{"uri":")") + kPixel +
                    R"("}],"buffers":)"));
  ASSERT_TRUE(textured.ok()) << textured.error().message;
  EXPECT_TRUE(textured->materials[0].base_color_texture.is_used());
  EXPECT_EQ(textured->textures.size(), 3u);
}

}  // namespace
}  // namespace lueur
