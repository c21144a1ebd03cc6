// SPDX-License-Identifier: MIT
// OBJ and MTL text. The first byte chooses which.
#include <string_view>

#include "base/check.h"
#include "fuzz_input.h"
#include "scene/mtl_read.h"
#include "scene/obj_geometry.h"

using namespace lueur;

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  Warnings warnings;
  if (data[0] % 4 == 0) {
    (void)read_mtl(text, "input", warnings);
    return 0;
  }
  auto geometry = read_obj_geometry(text, "input", fuzz_limits(), warnings);
  if (!geometry.ok()) return 0;
  const std::vector<ObjMaterialUse> materials(geometry->material_names.size());
  const auto meshes =
      make_obj_meshes(std::move(*geometry), materials, "input", fuzz_limits(), warnings);
  if (!meshes.ok()) return 0;

  Scene scene;
  scene.materials.resize(1);
  scene.nodes.resize(1);
  for (const Mesh& mesh : *meshes) {
    scene.instances.push_back({0, static_cast<int32_t>(scene.meshes.size())});
    scene.meshes.push_back(mesh);
  }
  check_scene(scene);
  return 0;
}
