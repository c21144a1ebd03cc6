// SPDX-License-Identifier: MIT
// One fault at a time in a clean file: each gives one line that names its place.
#include "scene/conformance/conformance.h"

#include <algorithm>
#include <utility>

#include "scene/conformance/findings.h"
#include "scene/gltf_test_files.h"

namespace lueur {
namespace {

std::vector<std::string> faults(const std::string& content) {
  const auto file =
      GltfFile::from_bytes({content.begin(), content.end()}, "file.gltf", LoadLimits());
  EXPECT_TRUE(file.ok()) << file.error().message;
  return file.ok() ? conformance_faults(*file) : std::vector<std::string>();
}

void expect_fault(const std::string& content, const std::string& line) {
  const std::vector<std::string> lines = faults(content);
  EXPECT_EQ(std::ranges::count(lines, line), 1) << line;
  for (const std::string& found : lines)
    if (found != line) ADD_FAILURE() << "instead of " << line << ": " << found;
}

TEST(Conformance, ACleanFileHasNoFaults) {
  EXPECT_TRUE(faults(triangle_json()).empty());
}

TEST(Conformance, PropertiesAreHeldAgainstTheSchema) {
  const std::string json = triangle_json();
  const std::string primitive = R"("indices":1)";
  expect_fault(with(json, primitive, R"("indices":1,"mode":9)"),
               "meshes[0].primitives[0].mode: 9 is not one of 0 to 6");
  expect_fault(with(json, primitive, R"("indices":7)"),
               "meshes[0].primitives[0].indices: 7 is not below the 2 accessors");
  expect_fault(with(json, R"({"mesh":0})", R"({"mesh":0,"name":1})"),
               "nodes[0].name: has to be a string");
  expect_fault(with(json, R"({"mesh":0})", R"({"mesh":0,"children":[]})"),
               "nodes[0].children: must not be empty");
  expect_fault(with(json, R"({"mesh":0})", R"({"mesh":0,"scale":[1,1]})"),
               "nodes[0].scale: has to have 3 items, not 2");
  expect_fault(with(json, R"("byteLength":6}])", R"("byteLength":6,"target":1}])"),
               "bufferViews[1].target: 1 is not 34962 or 34963");
  expect_fault(with(json, R"("scene":0)", R"("scene":0,"cameras":[{"type":"perspective",
"perspective":{"yfov":1}}])"),
               "cameras[0].perspective: znear is missing");
}

TEST(Conformance, ExtensionsHaveTheirPlaces) {
  const std::string json = triangle_json();
  const std::string node = R"({"mesh":0})";
  const std::string unlit = R"({"mesh":0,"extensions":{"KHR_materials_unlit":{}}})";
  expect_fault(with(json, node, unlit),
               "nodes[0].extensions.KHR_materials_unlit: is not listed in extensionsUsed");
  const std::string declared =
      with(json, R"("scene":0)", R"("extensionsUsed":["KHR_materials_unlit"],"scene":0)");
  expect_fault(with(declared, node, unlit),
               "nodes[0].extensions.KHR_materials_unlit: this extension has no place in such an "
               "object");
}

TEST(Conformance, ExtensionsOfGeometryAreHeldAgainstTheSchema) {
  const std::string json = triangle_json();
  const auto used = [&](const std::string& name) {
    return with(json, R"("scene":0)", R"("extensionsUsed":[")" + name + R"("],"scene":0)");
  };
  const std::string copies = used("EXT_mesh_gpu_instancing");
  expect_fault(
      with(copies, R"({"mesh":0})", R"({"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{}}})"),
      "nodes[0].extensions.EXT_mesh_gpu_instancing: attributes is missing");
  expect_fault(with(used("EXT_meshopt_compression"), R"({"byteLength":42)",
                    R"({"extensions":{"EXT_meshopt_compression":{"fallback":1}},"byteLength":42)"),
               "buffers[0].extensions.EXT_meshopt_compression.fallback: has to be true or false");
}

TEST(Conformance, DataAreHeldAgainstWhatIsDeclared) {
  const std::string json = triangle_json();
  expect_fault(with(json, R"("max":[1,1,0])", R"("max":[1,2,0])"),
               "accessors[0].max[1]: 2 is declared, but the data have 1.0");
  const std::string restart =
      bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) + bytes_of<uint16_t>({0, 1, 0xffff});
  expect_fault(with(json, base64(triangle_bytes()), base64(restart)),
               "meshes[0].primitives[0].indices: 65535.0 is no index: it is kept for restarting "
               "primitives");
  // Positions of length 1, 1 and 2 as normals.
  const std::string long_normal =
      bytes_of<float>({1, 0, 0, 0, 1, 0, 0, 0, 2}) + bytes_of<uint16_t>({0, 1, 2});
  const std::string lit = with(with(json, R"("POSITION":0)", R"("POSITION":0,"NORMAL":0)"),
                               R"("max":[1,1,0])", R"("max":[1,1,2])");
  expect_fault(with(lit, base64(triangle_bytes()), base64(long_normal)),
               "meshes[0].primitives[0].attributes.NORMAL: vector 2 has length 2.0 instead of 1");
}

TEST(Conformance, ContainerAndTextAreChecked) {
  const std::string json = triangle_json();
  expect_fault("\xef\xbb\xbf" + json, "the JSON text starts with a byte order mark");
  expect_fault(with(json, R"({"mesh":0})", R"({"mesh":0,"name":"a","name":"b"})"),
               "JSON key 'name' comes twice in one object: the last one counts");
}

TEST(Conformance, TheListStaysShort) {
  std::string nodes = R"([{"mesh":0})";
  for (int i = 0; i < 1000; ++i) nodes += R"(,{"camera":5})";
  const std::vector<std::string> lines =
      faults(with(triangle_json(), R"([{"mesh":0}])", nodes + "]"));
  ASSERT_EQ(lines.size(), conformance::Findings::kMaxLines + 1);
  EXPECT_EQ(lines.back(), "the file breaks the rules of glTF in 984 more places");
}

}  // namespace
}  // namespace lueur
