// SPDX-License-Identifier: MIT
#include "gltf_seeds.h"

#include <meshoptimizer.h>

#include "scene/gltf_test_bytes.h"

namespace lueur {
namespace {

constexpr int kByte = 5121, kShort = 5122, kUint16 = 5123, kFloat = 5126;

std::string listed(const std::string& list, const std::string& item) {
  return list.empty() ? item : list + ",\n" + item;
}

std::string named(const char* name, size_t value) {
  return '"' + std::string(name) + "\":" + std::to_string(value);
}

// Grows a file: each call adds to its end and gives back the index of what it added. Each view has
// a buffer of its own, so that an input can change the length of one without moving the others.
class Draft {
 public:
  size_t buffer(const std::string& bytes) {
    buffers_ = listed(buffers_, "{" + named("byteLength", bytes.size()) + R"(,"uri":")" +
                                    data_uri(bytes) + "\"}");
    return buffer_count_++;
  }
  size_t view(const std::string& bytes) {
    return add_view("{" + named("buffer", buffer(bytes)) + "," + named("byteLength", bytes.size()) +
                    "}");
  }
  // A view that unpacks to `count` elements of `stride` bytes.
  size_t packed_view(const std::string& packed, size_t count, size_t stride,
                     const std::string& mode) {
    const std::string sizes = named("byteStride", stride) + "," + named("count", count);
    const std::string length = named("byteLength", count * stride);
    buffers_ = listed(buffers_, "{" + length + "}");
    const size_t unpacked = buffer_count_++;
    const bool of_vertices = mode.find("ATTRIBUTES") != std::string::npos;
    return add_view("{" + named("buffer", unpacked) + "," + length +
                    (of_vertices ? "," + named("byteStride", stride) : "") +
                    R"(,"extensions":{"EXT_meshopt_compression":{)" +
                    named("buffer", buffer(packed)) + "," + named("byteLength", packed.size()) +
                    "," + sizes + "," + mode + "}}}");
  }
  size_t accessor(size_t view, int type, const char* shape, size_t count,
                  const std::string& rest = "") {
    return add_accessor(named("bufferView", view) + "," +
                        named("componentType", static_cast<size_t>(type)) + "," +
                        named("count", count) + R"(,"type":")" + shape + '"' + rest);
  }
  template <class T>
  size_t data(const std::vector<T>& values, int type, const char* shape, size_t count,
              const std::string& rest = "") {
    return accessor(view(bytes_of(values)), type, shape, count, rest);
  }
  size_t add_accessor(const std::string& members) {
    accessors_ = listed(accessors_, "{" + members + "}");
    return accessor_count_++;
  }
  size_t triangle() {
    return data<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, kFloat, "VEC3", 3,
                       R"(,"min":[0,0,0],"max":[1,1,0])");
  }

  // The file, of this data and `members` of the root.
  std::string text(const std::string& members) const {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],)" + members +
           ",\n\"buffers\":[" + buffers_ + "],\n\"bufferViews\":[" + views_ +
           "],\n\"accessors\":[" + accessors_ + "]}";
  }

 private:
  size_t add_view(const std::string& text) {
    views_ = listed(views_, text);
    return view_count_++;
  }

  std::string buffers_, views_, accessors_;
  size_t buffer_count_ = 0, view_count_ = 0, accessor_count_ = 0;
};

// A mesh of one primitive; `more` and `mesh_more` are members of these beside.
std::string mesh(const std::string& attributes, const std::string& more = "",
                 const std::string& mesh_more = "") {
  return R"("meshes":[{"primitives":[{"attributes":{)" + attributes + "}" + more + "}]" +
         mesh_more + "}]";
}

std::string extended(const std::string& extensions) {
  return R"("extensionsUsed":[)" + extensions + "],";
}

// A triangle with a skin of two joints, a morph target, and a spline for each kind of channel.
std::string deformed() {
  Draft draft;
  const size_t positions = draft.triangle();
  const size_t joints = draft.data<uint8_t>({0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0}, kByte, "VEC4", 3);
  const size_t weights = draft.data<uint8_t>({255, 0, 0, 0, 128, 127, 0, 0, 255, 0, 0, 0}, kByte,
                                             "VEC4", 3, R"(,"normalized":true)");
  const size_t normals = draft.data<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, kFloat, "VEC3", 3);
  const size_t lifted = draft.data<float>({0, 0, 1, 0, 0, 0, 0, 0, 2}, kFloat, "VEC3", 3,
                                          R"(,"min":[0,0,0],"max":[0,0,2])");
  const size_t binds = draft.data<float>({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,  0, 1,
                                          1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1},
                                         kFloat, "MAT4", 2);
  const std::string times = R"(,"min":[0],"max":[2])";
  const size_t keys = draft.data<float>({0, 2}, kFloat, "SCALAR", 2, times);
  const size_t spline = draft.data<float>({0, 0, 3, 0, 1, 0}, kFloat, "SCALAR", 6);
  const size_t turns = draft.data<float>({0, 0, 0, 1, 0, 0, 1, 0}, kFloat, "VEC4", 2);
  const std::string input = "{" + named("input", keys) + ",";
  return draft.text(
      R"("nodes":[{"mesh":0,"skin":0,"children":[1]},{"children":[2]},
{"translation":[0,1,0]}],
"skins":[{"joints":[1,2],"skeleton":1,)" +
      named("inverseBindMatrices", binds) + "}],\n" +
      mesh(named("POSITION", positions) + "," + named("NORMAL", normals) + "," +
               named("JOINTS_0", joints) + "," + named("WEIGHTS_0", weights),
           R"(,"targets":[{)" + named("POSITION", lifted) + "," + named("NORMAL", lifted) + "}]",
           R"(,"weights":[0.5])") +
      R"(,
"animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":"weights"}},
{"sampler":1,"target":{"node":2,"path":"rotation"}}],"samplers":[)" +
      input + named("output", spline) + R"(,"interpolation":"CUBICSPLINE"},)" + input +
      named("output", turns) + R"(,"interpolation":"STEP"}]}])");
}

template <class Encode>
std::string packed(size_t bound, const Encode& encode) {
  std::string bytes(bound, '\0');
  bytes.resize(encode(reinterpret_cast<unsigned char*>(bytes.data()), bytes.size()));
  return bytes;
}

std::string packed_vertices(const void* data, size_t count, size_t stride) {
  return packed(meshopt_encodeVertexBufferBound(count, stride),
                [&](unsigned char* to, size_t size) {
                  return meshopt_encodeVertexBuffer(to, size, data, count, stride);
                });
}

// One view of each mode, one of them behind a filter.
std::string meshopt() {
  const std::vector<float> positions{0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::vector<float> normals{0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::vector<unsigned int> indices{0, 1, 2};
  std::vector<int8_t> octahedral(3 * 4);
  meshopt_encodeFilterOct(octahedral.data(), 3, 4, 8, normals.data());
  const std::string triangles =
      packed(meshopt_encodeIndexBufferBound(3, 3), [&](unsigned char* to, size_t size) {
        return meshopt_encodeIndexBuffer(to, size, indices.data(), 3);
      });
  const std::string sequence =
      packed(meshopt_encodeIndexSequenceBound(3, 3), [&](unsigned char* to, size_t size) {
        return meshopt_encodeIndexSequence(to, size, indices.data(), 3);
      });
  Draft draft;
  const size_t position = draft.accessor(
      draft.packed_view(packed_vertices(positions.data(), 3, 12), 3, 12, R"("mode":"ATTRIBUTES")"),
      kFloat, "VEC3", 3, R"(,"min":[0,0,0],"max":[1,1,0])");
  const size_t normal =
      draft.accessor(draft.packed_view(packed_vertices(octahedral.data(), 3, 4), 3, 4,
                                       R"("mode":"ATTRIBUTES","filter":"OCTAHEDRAL")"),
                     5120, "VEC3", 3, R"(,"normalized":true)");
  const std::string attributes = named("POSITION", position) + "," + named("NORMAL", normal);
  const size_t faces = draft.accessor(draft.packed_view(triangles, 3, 2, R"("mode":"TRIANGLES")"),
                                      kUint16, "SCALAR", 3);
  const size_t strip = draft.accessor(draft.packed_view(sequence, 3, 2, R"("mode":"INDICES")"),
                                      kUint16, "SCALAR", 3);
  return draft.text(extended(R"("EXT_meshopt_compression","KHR_mesh_quantization")") +
                    R"("extensionsRequired":["EXT_meshopt_compression","KHR_mesh_quantization"],)" +
                    R"("nodes":[{"mesh":0}],)" +
                    mesh(attributes, "," + named("indices", faces) + R"(},{"attributes":{)" +
                                         attributes + R"(},"mode":5,)" + named("indices", strip)));
}

std::string instanced() {
  Draft draft;
  const size_t positions = draft.triangle();
  const size_t places = draft.data<float>({1, 0, 0, 0, 2, 0}, kFloat, "VEC3", 2);
  const size_t turns = draft.data<int16_t>({0, 0, 0, 32767, 0, 0, 23170, 23170}, kShort, "VEC4", 2,
                                           R"(,"normalized":true)");
  const size_t sizes = draft.data<float>({1, 1, 1, 2, 3, 4}, kFloat, "VEC3", 2);
  return draft.text(extended(R"("EXT_mesh_gpu_instancing")") + mesh(named("POSITION", positions)) +
                    R"(,
"nodes":[{"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{)" +
                    named("TRANSLATION", places) + "," + named("ROTATION", turns) + "," +
                    named("SCALE", sizes) + "}}}}]");
}

// Colours, and three sets of texture coordinates of which two are used.
std::string surface(const std::string& extensions, const std::string& materials,
                    const std::string& png) {
  Draft draft;
  const size_t positions = draft.triangle();
  const size_t colors = draft.data<uint8_t>({255, 0, 51, 102, 0, 0, 0, 0, 1, 2, 3, 4}, kByte,
                                            "VEC4", 3, R"(,"normalized":true)");
  const size_t places = draft.data<float>({0, 1, 2, 3, 4, 5}, kFloat, "VEC2", 3);
  const size_t shares =
      draft.data<uint16_t>({0, 1, 2, 3, 65535, 5}, kUint16, "VEC2", 3, R"(,"normalized":true)");
  const std::string attributes = named("POSITION", positions) + "," + named("COLOR_0", colors) +
                                 "," + named("TEXCOORD_0", places) + "," +
                                 named("TEXCOORD_1", shares) + "," + named("TEXCOORD_2", places);
  return draft.text(extended(extensions) + R"("nodes":[{"mesh":0}],)" +
                    mesh(attributes, R"(,"material":0)") + ",\n\"materials\":[" + materials + R"(],
"textures":[{"source":0,"sampler":0}],"samplers":[{"wrapS":33648,"magFilter":9728}],
"images":[{"uri":"data:image/png;base64,)" +
                    base64(png) + "\"}]");
}

constexpr const char* kTransformed =
    R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0,"texCoord":2,
"extensions":{"KHR_texture_transform":{"offset":[0.5,0.25],"rotation":0.7,"scale":[2,-3],
"texCoord":1}}}},"normalTexture":{"index":0,"scale":0.5},
"occlusionTexture":{"index":0,"strength":0.5},"emissiveTexture":{"index":0,"texCoord":1},
"emissiveFactor":[1,1,0],"alphaMode":"MASK","alphaCutoff":0.25,
"extensions":{"KHR_materials_unlit":{},"KHR_materials_emissive_strength":{"emissiveStrength":4},
"KHR_materials_specular":{"specularFactor":0.5}}})";

constexpr const char* kSpecularGlossiness =
    R"({"extensions":{"KHR_materials_pbrSpecularGlossiness":{"diffuseFactor":[0.5,0.5,0.5,0.25],
"specularFactor":[0.04,0.2,0.04],"glossinessFactor":0.75,"diffuseTexture":{"index":0},
"specularGlossinessTexture":{"index":0,"texCoord":1}}}})";

// Positions and indices with a sparse part, the indices without a view.
std::string sparse() {
  Draft draft;
  const size_t places = draft.view(bytes_of<uint8_t>({1, 2}));
  const size_t corners = draft.view(bytes_of<float>({1, 0, 0, 0, 1, 0}));
  const size_t indices = draft.view(bytes_of<uint16_t>({2, 1}));
  const auto part = [&](size_t values) {
    return R"(,"sparse":{"count":2,"indices":{)" + named("bufferView", places) +
           R"(,"componentType":5121},"values":{)" + named("bufferView", values) + "}}";
  };
  const size_t positions = draft.add_accessor(
      R"("componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0])" +
      part(corners));
  const size_t corner_numbers =
      draft.add_accessor(R"("componentType":5123,"count":3,"type":"SCALAR")" + part(indices));
  return draft.text(R"("nodes":[{"mesh":0}],)" +
                    mesh(named("POSITION", positions), "," + named("indices", corner_numbers)));
}

}  // namespace

std::vector<GltfSeed> gltf_seeds(const std::string& png) {
  return {{"deformed", deformed()},
          {"meshopt", meshopt()},
          {"instanced", instanced()},
          {"surface", surface(R"("KHR_texture_transform","KHR_materials_unlit",
"KHR_materials_emissive_strength","KHR_materials_specular")",
                              kTransformed, png)},
          {"specular-glossiness",
           surface(R"("KHR_materials_pbrSpecularGlossiness")", kSpecularGlossiness, png)},
          {"sparse", sparse()}};
}

}  // namespace lueur
