// SPDX-License-Identifier: MIT
#include "scene/gltf_load.h"

#include <turbojpeg.h>

#include "scene/gltf_test_files.h"

namespace lueur {
namespace {

// 2 x 1 pixels: (255, 0, 0) and (0, 128, 64).
constexpr const char* kPng =
    "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAIAAAB7QOjdAAAAD0lEQVR4nGP4z8DA0OAAAAdB"
    "AcBQ02axAAAAAElFTkSuQmCC";

std::string textured_json(const std::string& image_uri) {
  return with(with(triangle_json(), R"("indices":1)", R"("indices":1,"material":0)"),
              R"("buffers":)",
              R"("materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],
"textures":[{"source":0,"sampler":0}],"samplers":[{"wrapS":33071,"wrapT":33648,"magFilter":9728}],
"images":[{"uri":")" +
                  image_uri + R"("}],"buffers":)");
}

TEST_F(GltfTest, TriangleGetsFlatNormalsAndTangents) {
  const auto scene = load(triangle_json());
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  ASSERT_EQ(scene->meshes.size(), 1u);
  const Mesh& mesh = scene->meshes[0];
  ASSERT_EQ(mesh.vertices.size(), 3u);
  EXPECT_EQ(mesh.indices, (std::vector<uint32_t>{0, 1, 2}));
  EXPECT_EQ(mesh.vertices[1].position, glm::vec3(1, 0, 0));
  for (const Vertex& vertex : mesh.vertices) {
    EXPECT_EQ(vertex.normal, glm::vec3(0, 0, 1));
    EXPECT_NEAR(glm::dot(glm::vec3(vertex.tangent), vertex.normal), 0.0f, 1e-6f);
    EXPECT_EQ(std::abs(vertex.tangent.w), 1.0f);
  }
  EXPECT_EQ(scene->materials.size(), 1u);
  EXPECT_TRUE(scene->warnings.empty());
}

TEST_F(GltfTest, NodesAreReorderedAndShareTheirMesh) {
  const auto scene =
      load(with(with(triangle_json(), R"("nodes":[0])", R"("nodes":[2])"), R"([{"mesh":0}])",
                R"([{"mesh":0,"matrix":[2,0,0,0, 0,-2,0,0, 0,0,2,0, 5,6,7,1]},
{"mesh":0,"matrix":[1,0,0,0, 1,1,0,0, 0,0,1,0, 0,0,0,1]},
{"children":[0,1],"translation":[1,2,3],"rotation":[0,0,0.70710678,0.70710678]}])"));
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  EXPECT_EQ(scene->meshes.size(), 1u);
  ASSERT_EQ(scene->instances.size(), 2u);
  for (size_t i = 0; i < scene->nodes.size(); ++i)
    EXPECT_LT(scene->nodes[i].parent, static_cast<int32_t>(i));
  const auto world = pose(*scene, 0.0f);
  // The parent turns (x, y) to (-y, x) and moves by (1, 2, 3).
  const glm::vec4 mirrored = world[static_cast<size_t>(scene->instances[0].node)] *
                             glm::vec4(1.0f, 1.0f, 1.0f, 1.0f);  // (7, 4, 9) before the parent
  EXPECT_NEAR(glm::length(glm::vec3(mirrored) - glm::vec3(-3, 9, 12)), 0.0f, 1e-4f);
  EXPECT_FALSE(scene->nodes[static_cast<size_t>(scene->instances[0].node)].matrix.has_value());
  const glm::vec4 sheared = world[static_cast<size_t>(scene->instances[1].node)] *
                            glm::vec4(1.0f, 1.0f, 0.0f, 1.0f);  // (2, 1, 0) before the parent
  EXPECT_NEAR(glm::length(glm::vec3(sheared) - glm::vec3(0, 4, 3)), 0.0f, 1e-4f);
  EXPECT_TRUE(scene->nodes[static_cast<size_t>(scene->instances[1].node)].matrix.has_value());
}

TEST_F(GltfTest, StripsFansAndPointsBecomeTriangles) {
  const std::string quad = bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
  const auto json = [&](int mode) {
    return R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[
{"attributes":{"POSITION":0},"mode":)" +
           std::to_string(mode) + R"(}]}],"buffers":[{"byteLength":48,"uri":")" + data_uri(quad) +
           R"("}],"bufferViews":[{"buffer":0,"byteLength":48}],
"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"}]})";
  };
  const auto strip = load(json(5));
  ASSERT_TRUE(strip.ok());
  ASSERT_EQ(triangle_count(*strip), 2u);
  // Both triangles of the strip face +z although their order alternates.
  for (const Vertex& vertex : strip->meshes[0].vertices) EXPECT_EQ(vertex.normal.z, 1.0f);
  const auto fan = load(json(6));
  ASSERT_TRUE(fan.ok());
  EXPECT_EQ(triangle_count(*fan), 2u);
  EXPECT_EQ(fan->meshes[0].vertices[3].position, glm::vec3(0.0f));
  const auto points = load(json(0));
  ASSERT_TRUE(points.ok());
  EXPECT_EQ(triangle_count(*points), 0u);
  EXPECT_FALSE(points->warnings.empty());
}

TEST_F(GltfTest, SparseAndNormalizedAccessors) {
  // Positions as normalized 16-bit integers, padded to a stride of 8, vertex 2 replaced.
  const std::string bytes = bytes_of<int16_t>({0, 0, 0, 0, 32767, 0, 0, 0, 0, -32768, 0, 0}) +
                            bytes_of<int16_t>({0, 16384, 32767}) + bytes_of<uint8_t>({2, 0});
  const auto scene = load(
      R"({"asset":{"version":"2.0"},"extensionsRequired":["KHR_mesh_quantization"],
"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"buffers":[{"byteLength":32,"uri":")" +
      data_uri(bytes) + R"("}],"bufferViews":[{"buffer":0,"byteLength":24,"byteStride":8},
{"buffer":0,"byteOffset":24,"byteLength":6},{"buffer":0,"byteOffset":30,"byteLength":1}],
"accessors":[{"bufferView":0,"componentType":5122,"normalized":true,"count":3,"type":"VEC3",
"sparse":{"count":1,"indices":{"bufferView":2,"componentType":5121},"values":{"bufferView":1}}}]})");
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  const auto& vertices = scene->meshes[0].vertices;
  EXPECT_EQ(vertices[1].position, glm::vec3(1, 0, 0));
  EXPECT_EQ(vertices[2].position, glm::vec3(0.0f, 16384.0f / 32767.0f, 1.0f));
}

TEST_F(GltfTest, PngTextureAndSampler) {
  const auto scene = load(textured_json(kPng));
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  ASSERT_EQ(scene->textures.size(), 1u);
  const Texture& texture = scene->textures[0];
  EXPECT_EQ(texture.rgba, (std::vector<uint8_t>{255, 0, 0, 255, 0, 128, 64, 255}));
  EXPECT_EQ(texture.wrap_u, Wrap::clamp_to_edge);
  EXPECT_EQ(texture.wrap_v, Wrap::mirrored_repeat);
  EXPECT_TRUE(texture.nearest);
  EXPECT_EQ(scene->materials[0].base_color_texture.texture, 0);
}

TEST_F(GltfTest, JpegTexture) {
  const std::vector<uint8_t> gray(16 * 16 * 3, 100);
  unsigned char* jpeg = nullptr;
  unsigned long size = 0;
  const tjhandle handle = tjInitCompress();
  ASSERT_EQ(tjCompress2(handle, gray.data(), 16, 0, 16, TJPF_RGB, &jpeg, &size, TJSAMP_444, 95, 0),
            0);
  const std::string bytes(reinterpret_cast<const char*>(jpeg), size);
  tjFree(jpeg);
  tjDestroy(handle);
  const auto scene = load(textured_json(data_uri(bytes)));
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  ASSERT_EQ(scene->textures[0].rgba.size(), size_t{16 * 16 * 4});
  EXPECT_NEAR(scene->textures[0].rgba[0], 100, 1);
  EXPECT_EQ(scene->textures[0].rgba[3], 255);
  expect_refused(textured_json(data_uri(bytes.substr(0, bytes.size() / 2))),
                 {"images[0]", "damaged JPEG"});
}

TEST_F(GltfTest, FilesBesideTheAssetAreRead) {
  ASSERT_TRUE(write_file(folder_ / "asset" / "a b.bin", triangle_bytes()).ok());
  const std::string json = with(triangle_json(), data_uri(triangle_bytes()), "a%20b.bin");
  const auto scene = load(json);
  EXPECT_TRUE(scene.ok()) << scene.error().message;
  expect_refused(with(json, "a%20b.bin", "none.bin"), {"buffers[0].uri", "no such file"});
}

TEST_F(GltfTest, MaterialsCamerasAndLights) {
  const auto scene =
      load(with(with(with(triangle_json(), R"("indices":1)", R"("indices":1,"material":0)"),
                     R"([{"mesh":0}])",
                     R"([{"mesh":0,"camera":0,"extensions":{"KHR_lights_punctual":{"light":0}}}])"),
                R"("buffers":)",
                R"("extensionsUsed":["KHR_lights_punctual","KHR_materials_emissive_strength",
"KHR_materials_specular"],"cameras":[{"type":"perspective","perspective":{"yfov":0.5,"znear":0.25}}],
"extensions":{"KHR_lights_punctual":{"lights":[{"type":"spot","intensity":7,"color":[1,0.5,0],
"range":12,"spot":{"innerConeAngle":0.1,"outerConeAngle":0.2}}]}},
"materials":[{"emissiveFactor":[1,0.5,0],"doubleSided":true,"alphaMode":"BLEND",
"extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":8},
"KHR_materials_specular":{"specularFactor":0.25}},
"pbrMetallicRoughness":{"baseColorFactor":[0.1,0.2,0.3,0.4],"metallicFactor":0,
"roughnessFactor":0.5}}],"buffers":)"));
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  const Material& material = scene->materials.at(0);
  EXPECT_EQ(material.base_color, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
  EXPECT_EQ(material.emission, glm::vec3(8, 4, 0));
  EXPECT_EQ(material.metallic, 0.0f);
  EXPECT_EQ(material.roughness, 0.5f);
  EXPECT_EQ(material.specular, 0.25f);
  EXPECT_TRUE(material.double_sided);
  EXPECT_EQ(material.alpha_mode, AlphaMode::mask);
  EXPECT_EQ(scene->warnings.size(), 1u);  // blending
  EXPECT_EQ(scene->cameras.at(0).vertical_fov_rad, 0.5f);
  EXPECT_EQ(scene->cameras.at(0).near_m, 0.25f);
  EXPECT_EQ(scene->lights.at(0).kind, LightKind::spot);
  EXPECT_EQ(scene->lights.at(0).intensity, 7.0f);
  EXPECT_EQ(scene->lights.at(0).color, glm::vec3(1.0f, 0.5f, 0.0f));
  EXPECT_EQ(scene->lights.at(0).outer_cone_rad, 0.2f);
  EXPECT_EQ(scene->lights.at(0).range_m, 12.0f);
}

TEST_F(GltfTest, ExtrasSayWhatPassesNoLightOn) {
  for (const auto& [extras, passes] : {std::pair(R"({"lueur_passes_light_on":false})", false),
                                       {R"({"lueur_passes_light_on":true})", true},
                                       {R"({"mine":1})", true},
                                       {"[7]", true}}) {
    const auto scene = load(with(triangle_json(), R"({"mesh":0})",
                                 std::string(R"({"mesh":0,"extras":)") + extras + "}"));
    ASSERT_TRUE(scene.ok()) << scene.error().message;
    EXPECT_EQ(scene->instances[0].passes_light_on, passes) << extras;
  }
  expect_refused(
      with(triangle_json(), R"({"mesh":0})", R"({"mesh":0,"extras":{"lueur_passes_light_on":0}})"),
      {"nodes[0].extras.lueur_passes_light_on", "true or false"});
}

TEST_F(GltfTest, AnimationMovesItsNode) {
  const std::string keys = bytes_of<float>({0, 1, 0, 0, 0, 0, 0, 6});
  // The new accessors and views go behind the others, so that the numbers of those hold.
  std::string json = with(triangle_json(), R"("buffers":[)",
                          R"("animations":[{"samplers":[{"input":2,"output":3}],"channels":[
{"sampler":0,"target":{"node":0,"path":"translation"}}]}],"buffers":[)");
  json = with(json, R"("}],)", R"("},{"byteLength":32,"uri":")" + data_uri(keys) + R"("}],)");
  json = with(json, R"("byteLength":6}])",
              R"("byteLength":6},{"buffer":1,"byteLength":8},
{"buffer":1,"byteOffset":8,"byteLength":24}])");
  json = with(json, R"("SCALAR"}])",
              R"("SCALAR"},{"bufferView":2,"componentType":5126,"count":2,"type":"SCALAR"},
{"bufferView":3,"componentType":5126,"count":2,"type":"VEC3"}])");
  const auto animated = load(json);
  ASSERT_TRUE(animated.ok()) << animated.error().message;
  EXPECT_FLOAT_EQ(pose(*animated, 0.5f)[0][3][2], 3.0f);
  EXPECT_FLOAT_EQ(pose(*animated, 1.25f)[0][3][2], 1.5f);
}

}  // namespace
}  // namespace lueur
