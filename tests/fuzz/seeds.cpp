// SPDX-License-Identifier: MIT
// Writes the seeds that the corpora start from: fuzz_seeds FOLDER. They are made here and by the
// house's own writers, and have a few KiB each at most.
#include <turbojpeg.h>

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "base/file.h"
#include "gltf_seeds.h"
#include "image/exr.h"
#include "image/png.h"
#include "scene/gltf_export.h"
#include "scene/gltf_load.h"

using namespace lueur;
namespace fs = std::filesystem;

namespace {

bool all_written = true;

void store(const fs::path& path, std::string_view text) {
  fs::create_directories(path.parent_path());
  all_written = write_file(path, text).ok() && all_written;
}

std::string text_of(const std::vector<uint8_t>& bytes) {
  return {bytes.begin(), bytes.end()};
}

std::string png() {
  Image8 image{5, 3, 4, std::vector<uint8_t>(5 * 3 * 4)};
  for (size_t i = 0; i < image.samples.size(); ++i) image.samples[i] = static_cast<uint8_t>(i * 7);
  const auto bytes = encode_png(image, "seed");
  all_written = all_written && bytes.ok();
  return bytes.ok() ? text_of(*bytes) : "";
}

std::string jpeg(int flags) {
  const std::vector<uint8_t> rgb(16 * 16 * 3, 100);
  const tjhandle handle = tjInitCompress();
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  tjCompress2(handle, rgb.data(), 16, 0, 16, TJPF_RGB, &bytes, &size, TJSAMP_420, 80, flags);
  const std::string text(reinterpret_cast<const char*>(bytes), size);
  tjFree(bytes);
  tjDestroy(handle);
  return text;
}

// One textured quad with a camera, a light and an animation.
Scene scene() {
  Scene scene;
  scene.textures.push_back({"texture", 2, 2, std::vector<uint8_t>(16, 200)});
  Material material;
  material.base_color_texture = 0;
  material.normal_texture = 0;
  material.emission = {2.0f, 1.0f, 0.0f};
  material.alpha_mode = AlphaMode::mask;
  scene.materials.push_back(material);
  Mesh mesh;
  for (int i = 0; i < 4; ++i) {
    const glm::vec2 uv(i % 2, i / 2);
    mesh.vertices.push_back({glm::vec3(uv, 0.0f), glm::vec3(0, 0, 1), glm::vec4(1, 0, 0, 1), uv});
  }
  mesh.indices = {0, 1, 2, 2, 1, 3};
  mesh.primitives.push_back({0, 6, 0});
  scene.meshes.push_back(mesh);
  scene.nodes.resize(2);
  scene.nodes[1].parent = 0;
  scene.instances.push_back({.node = 1, .mesh = 0, .morph_weights = {}});
  scene.cameras.push_back({.name = "camera", .node = 0});
  scene.lights.push_back({.name = "light", .kind = LightKind::spot, .node = 1});
  scene.animation.push_back({.node = 1,
                             .path = AnimationPath::rotation,
                             .times_s = {0.0f, 1.0f},
                             .values = {{0, 0, 0, 1}, {0, 1, 0, 0}}});
  return scene;
}

void store_exr(const fs::path& path) {
  fs::create_directories(path.parent_path());
  const std::vector<ImageLayer> layers{{"", ImageF(7, 5, 3)}, {"depth", ImageF(7, 5, 1)}};
  all_written =
      write_exr(path, layers, {.attributes = {{"lueur.scene", "seed"}}}).ok() && all_written;
}

// A choice below 0xf0 takes a usual number; see fuzz_accessor.cpp.
std::string accessor_seed(char mode, char used, char length, char flags) {
  std::string bytes{mode, used};
  for (int view = 0; view < 6; ++view) bytes += {'\0', length, '\1'};
  for (int i = 0; i < 6; ++i) {
    const bool indices = i == 5;
    bytes += {flags, static_cast<char>(indices ? 3 : i == 2 ? 1 : i == 3 ? 2 : 0)};
    bytes += {static_cast<char>(indices ? 1 : 0), '\0', static_cast<char>(i)};
  }
  return bytes + std::string(192, '\0');
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return 2;
  const fs::path folder(arguments[1]);
  store(folder / "json" / "numbers",
        R"({"a":true,"b":-1.5e3,"c":"t\u00e9\n","d":[1,2,3],"e":{"f":null},"g":["x"]})");
  store(folder / "json" / "nested", R"({"a":[[[{"b":[[[0]]]}]]],"a":{}})");
  store(folder / "uri" / "data", "data:application/octet-stream;base64,AAECAwQ=");
  store(folder / "uri" / "percent", "data:,a%20b%00");
  store(folder / "uri" / "file", "folder/a%20b.bin");
  store(folder / "uri" / "outside", "a/%2e%2e/../b");
  store(folder / "glb" / "chunks", std::string("\0\2\0\0\1\0\0\0\0\0", 10));
  store(folder / "glb" / "three-chunks", std::string("\0\3\0\0\1\0\2\1\0\0\0", 11));
  store(folder / "accessor" / "triangles", accessor_seed(0, 0x4f, 1, 0));
  store(folder / "accessor" / "sparse", accessor_seed(1, 0x47, 5, 0x60));
  store(folder / "accessor" / "bounds", accessor_seed(2, 0x0f, 5, char(0x9c)));
  store(folder / "image" / "png", png());
  store(folder / "image" / "jpeg", jpeg(0));
  store(folder / "image" / "jpeg-progressive", jpeg(TJFLAG_PROGRESSIVE));
  store(folder / "obj" / "cube",
        "1o part\nmtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0 1\nvt 0 0\nvt 1 0.5\nvn 0 0 1\n"
        "usemtl red\ns 1\nf 1/1/1 2/2/1 3/1/1 4/2/1\ns off\nf -4//1 -3//1 -2//1\ng other\nf 1 2 "
        "\\\n3\n");
  store(folder / "obj" / "mtl",
        "0newmtl red\nKd 0.8 0.1 0.1\nKe 1 1 1\nNs 20\nd 0.5\nillum 2\nTf 1 1 1\n"
        "map_Kd -s 2 2 -o 0.5 0 -clamp on a.png\nbump -bm 0.5 b.png\nPr 0.5\nPm 0\n");
  const std::string header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=2\n\n";
  store(folder / "hdr" / "flat", header + "-Y 2 +X 2\n" + std::string(16, '\x80'));
  store(folder / "hdr" / "runs",
        header + "-Y 1 +X 8\n" + std::string("\2\2\0\10\x88\1\x88\2\x88\3\x88\x80", 12));
  store_exr(folder / "exr" / "layers");
  fs::create_directories(folder / "gltf");
  all_written = export_glb(scene(), folder / "gltf" / "glb").ok() && all_written;
  store(folder / "gltf" / "text",
        R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],
"nodes":[{"mesh":0,"scale":[1,2,3]},{"camera":0,"children":[2]},{"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}],
"cameras":[{"type":"perspective","perspective":{"yfov":0.5,"znear":0.1}}],
"materials":[{"emissiveFactor":[1,0.5,0],"pbrMetallicRoughness":{"metallicFactor":0}}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0,"mode":5}]}],
"buffers":[{"byteLength":42,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAABAAIA"}],
"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
{"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}]})");
  for (const GltfSeed& seed : gltf_seeds(png())) {
    store(folder / "gltf" / seed.name, seed.text);
    const auto loaded = decode_gltf({seed.text.begin(), seed.text.end()}, seed.name, {});
    if (!loaded.ok()) std::fprintf(stderr, "%s\n", loaded.error().message.c_str());
    for (size_t i = 0; loaded.ok() && i < loaded->warnings.size(); ++i)
      std::fprintf(stderr, "%s: %s\n", seed.name.c_str(), loaded->warnings[i].c_str());
    all_written = all_written && loaded.ok();
  }
  if (!all_written) std::fprintf(stderr, "not all seeds could be written, or they do not load\n");
  return all_written ? 0 : 1;
}
