// SPDX-License-Identifier: MIT
// Files that are damaged or made to harm: each is refused in one line that names the place.
#include <cmath>
#include <limits>

#include "scene/gltf_test_files.h"

namespace lueur {
namespace {
namespace fs = std::filesystem;

std::string u32(uint32_t value) {
  return bytes_of<uint32_t>({value});
}

std::string glb_of(const std::string& json, const std::string& binary) {
  const std::string chunks = u32(static_cast<uint32_t>(json.size())) + "JSON" + json +
                             u32(static_cast<uint32_t>(binary.size())) + std::string("BIN\0", 4) +
                             binary;
  return "glTF" + u32(2) + u32(static_cast<uint32_t>(chunks.size() + 12)) + chunks;
}

std::string good_glb() {
  std::string json = with(triangle_json(), R"(,"uri":")" + data_uri(triangle_bytes()) + "\"", "");
  json.append((4 - json.size() % 4) % 4, ' ');
  return glb_of(json, triangle_bytes() + std::string(2, '\0'));
}

TEST_F(GltfTest, EveryTruncationOfAGlbIsRefused) {
  const std::string glb = good_glb();
  ASSERT_TRUE(load(glb).ok());
  for (size_t size = 0; size < glb.size(); ++size)
    ASSERT_FALSE(load(std::string_view(glb).substr(0, size)).ok()) << size;
  expect_refused(glb.substr(0, 100), {"GLB header tells", "100"});
}

TEST_F(GltfTest, GlbChunkLengthsAreChecked) {
  std::string glb = good_glb();
  glb.replace(12, 4, u32(0xfffffff0u));
  expect_refused(glb, {"GLB chunk tells 4294967280 bytes"});
  glb = good_glb();
  glb.replace(4, 4, u32(1));
  expect_refused(glb, {"GLB version 1"});
}

TEST_F(GltfTest, MalformedJsonIsRefused) {
  expect_refused("", {"not valid JSON"});
  expect_refused("[]", {"not an object"});
  expect_refused("{\"asset\":", {"not valid JSON"});
  expect_refused(R"({"asset":{"version":"2.0"},"scene":1e999})", {"file.gltf"});
  expect_refused(R"({"asset":{"version":"1.0"}})", {"asset.version", "'1.0'"});
  expect_refused(R"({})", {"asset.version"});
  std::string deep = R"({"asset":{"version":"2.0"},"extras":)";
  deep += std::string(100'000, '[') + std::string(100'000, ']') + "}";
  expect_refused(deep, {"nested deeper than 64"});
  LoadLimits few;
  few.json_values = 10;
  expect_refused(triangle_json(), {"more than 10 JSON values"}, few);
}

TEST_F(GltfTest, NumbersOfTheWrongKindAreNamed) {
  const std::string json = triangle_json();
  expect_refused(with(json, R"("mesh":0)", R"("mesh":-1)"), {"nodes[0].mesh"});
  expect_refused(with(json, R"("mesh":0)", R"("mesh":"0")"), {"nodes[0].mesh"});
  expect_refused(with(json, R"("mesh":0)", R"("mesh":0.5)"), {"nodes[0].mesh"});
  expect_refused(with(json, R"("mesh":0)", R"("mesh":18446744073709551615)"), {"nodes[0].mesh"});
  expect_refused(with(json, R"("scene":0)", R"("scene":4)"),
                 {"scene: 4 is not below the 1 scenes"});
  expect_refused(with(json, R"("nodes":[0])", R"("nodes":[7])"), {"scenes[0].nodes[0]: 7"});
  expect_refused(with(json, R"("nodes":[{"mesh":0}])", R"("nodes":{"mesh":0})"), {"nodes"});
}

TEST_F(GltfTest, ReadsOutsideTheBuffersAreRefused) {
  const std::string json = triangle_json();
  expect_refused(with(json, R"("bufferView":1,)", R"("bufferView":12,)"),
                 {"accessors[1].bufferView: 12 is not below the 2 buffer views"});
  expect_refused(with(json, R"("count":3,"type":"VEC3")", R"("count":4,"type":"VEC3")"),
                 {"accessors[0]", "need 48 bytes", "has 36"});
  expect_refused(
      with(json, R"("count":3,"type":"VEC3")", R"("count":18446744073709551615,"type":"VEC3")"),
      {"accessors[0].count"});
  expect_refused(with(json, R"("count":3,"type":"VEC3")", R"("count":60000000,"type":"VEC3")"),
                 {"accessors[0]"});
  expect_refused(with(json, R"("byteOffset":36)", R"("byteOffset":37)"), {"bufferViews[1]"});
  expect_refused(with(json, R"("byteOffset":36)", R"("byteOffset":18446744073709551610)"),
                 {"bufferViews[1].byteOffset"});
  expect_refused(with(json, R"("byteLength":42)", R"("byteLength":43)"), {"buffers[0].byteLength"});
  expect_refused(with(json, R"("byteLength":36})", R"("byteLength":36,"byteStride":4})"),
                 {"accessors[0].bufferView", "stride 4"});
  expect_refused(with(json, R"("componentType":5126)", R"("componentType":5127)"),
                 {"accessors[0].componentType"});
}

TEST_F(GltfTest, IndicesBeyondTheVerticesAreRefused) {
  const std::string bytes =
      bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) + bytes_of<uint16_t>({0, 1, 3});
  expect_refused(with(triangle_json(), base64(triangle_bytes()), base64(bytes)),
                 {"meshes[0].primitives[0].indices: 3 is not below the 3 vertices"});
}

TEST_F(GltfTest, VerticesThatAreNotFiniteAreNamed) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::string bytes =
      bytes_of<float>({0, 0, 0, 1, nan, 0, 0, 1, 0}) + bytes_of<uint16_t>({0, 1, 2});
  expect_refused(with(triangle_json(), base64(triangle_bytes()), base64(bytes)),
                 {"meshes[0].primitives[0].attributes.POSITION", "vertex 1", "'tri'"});
  // The same bytes as normals.
  std::string json = with(triangle_json(), R"("POSITION":0)", R"("POSITION":0,"NORMAL":2)");
  json = with(json, R"("}],)", R"("},{"byteLength":42,"uri":")" + data_uri(bytes) + R"("}],)");
  json = with(json, R"("byteLength":6}],)", R"("byteLength":6},{"buffer":1,"byteLength":36}],)");
  json = with(json, R"("SCALAR"}])",
              R"("SCALAR"},{"bufferView":2,"componentType":5126,"count":3,"type":"VEC3"}])");
  expect_refused(json, {"meshes[0].primitives[0].attributes.NORMAL", "vertex 1", "'tri'"});
}

TEST_F(GltfTest, NodesThatAreNotATreeAreRefused) {
  const std::string json = triangle_json();
  expect_refused(with(json, R"([{"mesh":0}])", R"([{"mesh":0},{"children":[2]},{"children":[1]}])"),
                 {"nodes", "its own ancestor"});
  expect_refused(with(json, R"([{"mesh":0}])", R"([{"mesh":0,"children":[0]}])"), {"nodes"});
  expect_refused(
      with(json, R"([{"mesh":0}])", R"([{"children":[1,2]},{"children":[3]},{"children":[3]},{}])"),
      {"nodes[2].children", "node 3"});
  expect_refused(with(json, R"("nodes":[0]}],)", R"("nodes":[0,0]}],)"), {"listed twice"});
  expect_refused(with(json, R"([{"mesh":0}])", R"([{"mesh":0,"rotation":[0,0,0,0]}])"),
                 {"nodes[0].rotation"});
  expect_refused(with(json, R"([{"mesh":0}])",
                      R"([{"scale":[1e30,1,1],"children":[1]},{"scale":[1e30,1,1]}])"),
                 {"node 1", "not finite"});
}

TEST_F(GltfTest, VerticesMovedToInfinityAreRefused) {
  expect_refused(with(with(triangle_json(), base64(triangle_bytes()),
                           base64(bytes_of<float>({0, 0, 0, 1e30f, 0, 0, 0, 1, 0}) +
                                  bytes_of<uint16_t>({0, 1, 2}))),
                      R"([{"mesh":0}])", R"([{"mesh":0,"scale":[1e10,1,1]}])"),
                 {"mesh 'tri'", "beyond the range"});
}

TEST_F(GltfTest, ATowerOfNodesDoesNotOverflowTheStack) {
  std::string nodes = R"([{"mesh":0})";
  for (int i = 0; i < 200'000; ++i) nodes += ",{\"children\":[" + std::to_string(i) + "]}";
  const auto scene = load(with(with(triangle_json(), R"([{"mesh":0}])", nodes + "]"),
                               R"("nodes":[0])", R"("nodes":[200000])"));
  ASSERT_TRUE(scene.ok()) << scene.error().message;
  EXPECT_EQ(scene->nodes.size(), 200'001u);
}

TEST_F(GltfTest, UrisStayInTheFolder) {
  ASSERT_TRUE(write_file(folder_ / "secret.bin", triangle_bytes()).ok());
  const std::string json = triangle_json();
  const std::string uri = data_uri(triangle_bytes());
  for (const char* bad : {"../secret.bin", "%2e%2e/secret.bin", "a/../../secret.bin", "/etc/passwd",
                          "file:///etc/passwd", "http://example.com/a.bin", "..", "%", "a%00b"})
    expect_refused(with(json, uri, bad), {"buffers[0].uri", std::string("'") + bad});
  expect_refused(with(json, uri, "%2fetc/passwd"), {"buffers[0].uri", "leads out"});
  fs::create_symlink(folder_, folder_ / "asset" / "up");
  expect_refused(with(json, uri, "up/secret.bin"), {"buffers[0].uri", "leads out"});
  fs::create_symlink(folder_ / "secret.bin", folder_ / "asset" / "link.bin");
  expect_refused(with(json, uri, "link.bin"), {"buffers[0].uri", "leads out"});
  expect_refused(with(json, uri, "data:;base64,####"), {"buffers[0].uri", "base64"});
}

TEST_F(GltfTest, AFileInMemoryNamesNoOthers) {
  const std::string json = triangle_json();
  const auto decode = [](const std::string& text) {
    return decode_gltf({text.begin(), text.end()}, "file.gltf");
  };
  EXPECT_TRUE(decode(json).ok());
  const auto scene = decode(with(json, data_uri(triangle_bytes()), "triangle.bin"));
  ASSERT_FALSE(scene.ok());
  EXPECT_NE(scene.error().message.find("buffers[0].uri"), std::string::npos);
}

TEST_F(GltfTest, LimitsAreCheckedBeforeMemoryIsTaken) {
  LoadLimits limits;
  limits.vertices = 2;
  expect_refused(triangle_json(), {"accessors[0]"}, [] {
    LoadLimits few;
    few.vertices = few.indices = 2;
    return few;
  }());
  expect_refused(triangle_json(), {"more than 2 vertices"}, limits);
  limits = {};
  limits.nodes = 0;
  expect_refused(triangle_json(), {"nodes"}, limits);
  limits = {};
  limits.file_bytes = 100;
  expect_refused(triangle_json(), {"limit of 100"}, limits);
}

TEST_F(GltfTest, ImagesAreNotBelieved) {
  // A PNG whose header tells 100,000 x 100,000 pixels.
  const std::string json =
      with(with(triangle_json(), R"("indices":1)", R"("indices":1,"material":0)"), R"("buffers":)",
           R"("materials":[{"normalTexture":{"index":0}}],"textures":[{"source":0}],
"images":[{"uri":"data:image/png;base64,iVBORw0KGgoAAAANSUhEUgABhqAAAYagCAIAAAAnMJyfAAAADElEQVR4nGNgYGAAAAAEAAH2FzhVAAAAAElFTkSuQmCC"}],"buffers":)");
  expect_refused(json, {"images[0]", "100000 x 100000"});
  LoadLimits large;
  large.texture_side_px = 1u << 20;
  expect_refused(json, {"images[0]", "all textures together"}, large);
  expect_refused(with(json, "iVBORw0KGgoAAAANSUhEUgABhqAAAYag", "iVBORw0KGgoAAAANSUhEUgAAAAEAAAAB"),
                 {"images[0]", "damaged PNG"});
  expect_refused(with(json, "iVBORw0KGgo", "UklGRhoAAAA"), {"images[0]", "WebP"});
}

TEST_F(GltfTest, RequiredExtensionsAreRefusedByName) {
  for (const char* name : {"KHR_draco_mesh_compression", "KHR_texture_basisu", "VENDOR_unheard_of"})
    expect_refused(with(triangle_json(), R"("scene":0)",
                        std::string(R"("scene":0,"extensionsRequired":[")") + name + "\"]"),
                   {"extensionsRequired", name, "; re"});
}

}  // namespace
}  // namespace lueur
