// SPDX-License-Identifier: MIT
#include "scene/builtin/detailed_object.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/check.h"
#include "scene/builtin/dragon.h"
#include "scene/builtin/room_parts.h"
#include "scene/builtin/scene_builder.h"

namespace lueur::builtin {
namespace {

constexpr std::string_view kObjectName = "detailed object";

// Unglazed porcelain: pale, so that it shows the colour of the light that reaches it.
Pattern porcelain_pattern() {
  return {[](glm::vec2 uv) {
            return glm::mix(glm::vec3(0.80f, 0.76f, 0.69f), glm::vec3(0.90f, 0.88f, 0.84f),
                            tiling_noise(uv, 5, 5, 91));
          },
          [](glm::vec2 uv) { return 0.0012f * tiling_noise(uv, 40, 3, 92); }};
}

std::vector<MeshInstance>::const_iterator find_object(const Scene& scene) {
  return std::find_if(scene.instances.begin(), scene.instances.end(), [&](const MeshInstance& i) {
    return scene.meshes[i.mesh].name == kObjectName;
  });
}

}  // namespace

void add_detailed_object(Scene& scene, const DetailedObject& object, int32_t parent) {
  LUEUR_CHECK(!has_detailed_object(scene));
  const int32_t material = add_patterned_material(scene, "porcelain", glm::vec3(1.0f), 0.55f, 256,
                                                  0.8f, porcelain_pattern());
  MeshBuilder builder;
  builder.set_material(material, 0.8f);
  add_dragon(builder, object.triangles);
  const int32_t node = add_mesh(scene, builder.finish(std::string(kObjectName)));
  scene.nodes[node].parent = parent;
  float top = 0.0f;
  for (const Vertex& v : scene.meshes.back().vertices) top = std::max(top, v.position.y);
  scene.nodes[node].scale = glm::vec3(object.height_m / top);
}

bool has_detailed_object(const Scene& scene) {
  return find_object(scene) != scene.instances.end();
}

}  // namespace lueur::builtin
