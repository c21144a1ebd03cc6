// SPDX-License-Identifier: MIT
#include "scene/gltf_export.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <map>
#include <new>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/check.h"
#include "base/file.h"
#include "base/try.h"

namespace lueur {
namespace {

using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "glTF is little-endian");
static_assert(sizeof(Vertex) == 64, "vertices are written as they lie in memory");

// glTF's numbers for component types, buffer targets and sampler modes.
constexpr int kFloat = 5126, kUint32 = 5125, kUint16 = 5123;
constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963;
constexpr int kNearest = 9728, kLinear = 9729, kLinearMipmapLinear = 9987;
constexpr int kClampToEdge = 33071, kMirroredRepeat = 33648, kRepeat = 10497;

Json vector_json(glm::vec3 v) {
  return Json::array({v.x, v.y, v.z});
}
Json vector_json(glm::vec4 v) {
  return Json::array({v.x, v.y, v.z, v.w});
}

int wrap_mode(Wrap wrap) {
  switch (wrap) {
    case Wrap::clamp_to_edge:
      return kClampToEdge;
    case Wrap::mirrored_repeat:
      return kMirroredRepeat;
    case Wrap::repeat:
      break;
  }
  return kRepeat;
}

// Encodes a texture, without alpha if it is opaque everywhere.
Result<std::vector<uint8_t>> encode_png(const Texture& texture) {
  LUEUR_CHECK_OP(texture.rgba.size(), ==, size_t{texture.width} * texture.height * 4);
  std::vector<uint8_t> pixels;
  bool opaque = true;
  for (size_t k = 3; k < texture.rgba.size(); k += 4) opaque = opaque && texture.rgba[k] == 255;
  if (opaque) {
    for (size_t k = 0; k < texture.rgba.size(); ++k)
      if (k % 4 != 3) pixels.push_back(texture.rgba[k]);
  } else {
    pixels = texture.rgba;
  }
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = texture.width;
  image.height = texture.height;
  image.format = opaque ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;

  // Give room for the worst case at once; asking for the size would encode twice.
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::vector<uint8_t> png(size);
  if (png_image_write_to_memory(&image, png.data(), &size, 0, pixels.data(), 0, nullptr) == 0)
    return Error{ErrorKind::output,
                 "texture '" + texture.name + "' cannot be encoded: " + image.message};
  png.resize(size);
  return png;
}

// Collects the file's JSON and its one buffer.
class GlbWriter {
 public:
  explicit GlbWriter(const Scene& scene) : scene_(scene) {
    json_["asset"] = {{"version", "2.0"}, {"generator", "lueur"}};
  }

  Result<std::vector<uint8_t>> write() {
    LUEUR_TRY_VOID(add_textures());
    add_materials();
    add_meshes();
    add_skins();
    add_cameras();
    add_lights();
    add_nodes();
    add_animation();
    return assemble();
  }

 private:
  // Appends bytes to the buffer, aligned for any component type; returns the view's index.
  int add_view(std::span<const uint8_t> bytes, int target = 0, int stride = 0) {
    buffer_.resize((buffer_.size() + 3) / 4 * 4);
    Json view = {{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes.size()}};
    if (stride != 0) view["byteStride"] = stride;
    if (target != 0) view["target"] = target;
    buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
    return add_to("bufferViews", std::move(view));
  }

  template <class T>
  static std::span<const uint8_t> bytes_of(std::span<const T> values) {
    return {reinterpret_cast<const uint8_t*>(values.data()), values.size_bytes()};
  }

  int add_accessor(int view, size_t offset, int component, const char* type, size_t count) {
    return add_to("accessors", {{"bufferView", view},
                                {"byteOffset", offset},
                                {"componentType", component},
                                {"count", count},
                                {"type", type}});
  }

  // Appends to a top-level array, which is made with its first element: glTF forbids empty ones.
  int add_to(const char* array, Json element) {
    json_[array].push_back(std::move(element));
    return int(json_[array].size()) - 1;
  }

  void use_extension(const char* name) {
    Json& used = json_["extensionsUsed"];
    if (std::find(used.begin(), used.end(), name) == used.end()) used.push_back(name);
  }

  Result<void> add_textures() {
    for (const Texture& texture : scene_.textures) {
      LUEUR_TRY(png, encode_png(texture));
      const int image = add_to(
          "images",
          {{"name", texture.name}, {"mimeType", "image/png"}, {"bufferView", add_view(png)}});
      add_to("textures",
             {{"name", texture.name}, {"sampler", add_sampler(texture)}, {"source", image}});
    }
    return {};
  }

  int add_sampler(const Texture& texture) {
    const Json sampler = {{"magFilter", texture.nearest ? kNearest : kLinear},
                          {"minFilter", kLinearMipmapLinear},
                          {"wrapS", wrap_mode(texture.wrap_u)},
                          {"wrapT", wrap_mode(texture.wrap_v)}};
    const Json& samplers = json_["samplers"];
    const auto found = std::find(samplers.begin(), samplers.end(), sampler);
    return found != samplers.end() ? int(found - samplers.begin()) : add_to("samplers", sampler);
  }

  void add_materials() {
    for (const Material& m : scene_.materials) {
      Json pbr = {{"baseColorFactor", vector_json(m.base_color)},
                  {"metallicFactor", m.metallic},
                  {"roughnessFactor", m.roughness}};
      set_texture(pbr, "baseColorTexture", m.base_color_texture);
      set_texture(pbr, "metallicRoughnessTexture", m.metallic_roughness_texture);
      Json material = {{"name", m.name}, {"pbrMetallicRoughness", std::move(pbr)}};
      if (set_texture(material, "normalTexture", m.normal_texture))
        material["normalTexture"]["scale"] = m.normal_scale;
      set_texture(material, "emissiveTexture", m.emission_texture);
      set_emission(material, m.emission);
      set_specular(material, m.specular);
      if (m.unlit) {
        material["extensions"]["KHR_materials_unlit"] = Json::object();
        use_extension("KHR_materials_unlit");
      }
      if (m.alpha_mode == AlphaMode::mask) {
        material["alphaMode"] = "MASK";
        material["alphaCutoff"] = m.alpha_cutoff;
      }
      if (m.double_sided) material["doubleSided"] = true;
      add_to("materials", std::move(material));
    }
  }

  bool set_texture(Json& object, const char* slot, const TextureUse& use) {
    if (!use.is_used()) return false;
    object[slot] = {{"index", use.texture}};
    if (use.uv_set != 0) object[slot]["texCoord"] = use.uv_set;
    if (use.transform != TextureUse().transform) {
      object[slot]["extensions"]["KHR_texture_transform"] = transform_json(use.transform);
      use_extension("KHR_texture_transform");
    }
    return true;
  }

  // Scale, angle and offset of a transform without shear, which is all that files can bring.
  static Json transform_json(const glm::mat3x2& m) {
    const glm::vec2 scale(glm::length(m[0]),
                          glm::length(m[1]) * (glm::determinant(glm::mat2(m)) < 0.0f ? -1 : 1));
    return {{"offset", {m[2].x, m[2].y}},
            {"rotation", std::atan2(-m[0].y, m[0].x)},
            {"scale", {scale.x, scale.y}}};
  }

  // A factor of up to 1 for each channel, times a strength where that does not reach.
  void set_emission(Json& material, glm::vec3 emission) {
    const float strength = std::max({emission.x, emission.y, emission.z, 1.0f});
    if (emission != glm::vec3(0.0f))
      material["emissiveFactor"] = vector_json(glm::min(emission / strength, glm::vec3(1.0f)));
    if (strength <= 1.0f) return;
    material["extensions"]["KHR_materials_emissive_strength"] = {{"emissiveStrength", strength}};
    use_extension("KHR_materials_emissive_strength");
  }

  void set_specular(Json& material, float specular) {
    if (specular == 1.0f) return;
    material["extensions"]["KHR_materials_specular"] = {{"specularFactor", specular}};
    use_extension("KHR_materials_specular");
  }

  void add_meshes() {
    for (const Mesh& mesh : scene_.meshes) {
      bool has_triangles = false;
      for (const Primitive& p : mesh.primitives) has_triangles |= p.index_count > 0;
      mesh_index_.push_back(has_triangles ? add_mesh(mesh) : kNone);
    }
  }

  int add_mesh(const Mesh& mesh) {
    // Write the vertices as they are; all primitives of the mesh share them.
    const std::span<const Vertex> vertices(mesh.vertices);
    const int view = add_view(bytes_of(vertices), kArrayBuffer, sizeof(Vertex));
    const auto attribute = [&](size_t offset, const char* type, int component = kFloat) {
      return add_accessor(view, offset, component, type, vertices.size());
    };
    const int position = attribute(offsetof(Vertex, position), "VEC3");
    glm::vec3 low = vertices[0].position, high = low;
    for (const Vertex& vertex : vertices) {
      low = glm::min(low, vertex.position);
      high = glm::max(high, vertex.position);
    }
    json_["accessors"][position]["min"] = vector_json(low);
    json_["accessors"][position]["max"] = vector_json(high);
    const int normal = attribute(offsetof(Vertex, normal), "VEC3");
    const int uv = attribute(offsetof(Vertex, uv), "VEC2");
    int tangent = kNone;
    // What all vertices have as if it were not there need not be written.
    Json more = Json::object();
    const auto any = [&](auto&& differs) {
      return std::any_of(vertices.begin(), vertices.end(), differs);
    };
    if (any([](const Vertex& v) { return v.uv_2 != glm::vec2(0.0f); }))
      more["TEXCOORD_1"] = attribute(offsetof(Vertex, uv_2), "VEC2");
    if (any([](const Vertex& v) { return v.color != glm::u16vec4(kFullColor); })) {
      more["COLOR_0"] = attribute(offsetof(Vertex, color), "VEC4", kUint16);
      json_["accessors"].back()["normalized"] = true;
    }
    add_influences(mesh, more);
    const Json targets = add_morph_targets(mesh);

    const std::span<const uint32_t> indices(mesh.indices);
    const int index_view = add_view(bytes_of(indices), kElementArrayBuffer);
    Json primitives = Json::array();
    for (const Primitive& p : mesh.primitives) {
      if (p.index_count == 0) continue;
      Json attributes = {{"POSITION", position}, {"NORMAL", normal}, {"TEXCOORD_0", uv}};
      attributes.update(more);
      if (scene_.materials[p.material].normal_texture.is_used()) {
        if (tangent == kNone) tangent = attribute(offsetof(Vertex, tangent), "VEC4");
        attributes["TANGENT"] = tangent;
      }
      const int index = add_accessor(index_view, size_t{p.first_index} * sizeof(uint32_t), kUint32,
                                     "SCALAR", p.index_count);
      primitives.push_back(
          {{"attributes", std::move(attributes)}, {"indices", index}, {"material", p.material}});
      if (!targets.empty()) primitives.back()["targets"] = targets;
    }
    return add_to("meshes", {{"name", mesh.name}, {"primitives", std::move(primitives)}});
  }

  template <class T>
  int add_array(std::span<const T> values, int component, const char* type, int target = 0) {
    return add_accessor(add_view(bytes_of(values), target), 0, component, type, values.size());
  }

  void add_influences(const Mesh& mesh, Json& attributes) {
    if (mesh.influences.empty()) return;
    std::vector<glm::u16vec4> joints;
    std::vector<glm::vec4> weights;
    for (const JointInfluence& influence : mesh.influences) {
      joints.push_back(influence.joints);
      weights.push_back(influence.weights);
      // A joint without weight has to be 0.
      for (int k = 0; k < 4; ++k)
        if (influence.weights[k] == 0.0f) joints.back()[k] = 0;
    }
    attributes["JOINTS_0"] =
        add_array(std::span<const glm::u16vec4>(joints), kUint16, "VEC4", kArrayBuffer);
    attributes["WEIGHTS_0"] =
        add_array(std::span<const glm::vec4>(weights), kFloat, "VEC4", kArrayBuffer);
  }

  Json add_morph_targets(const Mesh& mesh) {
    Json targets = Json::array();
    for (const MorphTarget& target : mesh.morph_targets) {
      Json object = Json::object();
      const auto add = [&](const char* key, const std::vector<glm::vec3>& values) {
        if (!values.empty())
          object[key] = add_array(std::span<const glm::vec3>(values), kFloat, "VEC3", kArrayBuffer);
        return !values.empty();
      };
      // A target without any array is not allowed: one of zeros stands for it.
      std::vector<glm::vec3> positions = target.positions;
      if (positions.empty()) positions.resize(mesh.vertices.size(), glm::vec3(0.0f));
      add("POSITION", positions);
      set_range(json_["accessors"].back(), positions);
      add("NORMAL", target.normals);
      targets.push_back(std::move(object));
    }
    return targets;
  }

  static void set_range(Json& accessor, const std::vector<glm::vec3>& values) {
    glm::vec3 low = values[0], high = low;
    for (const glm::vec3& value : values) {
      low = glm::min(low, value);
      high = glm::max(high, value);
    }
    accessor["min"] = vector_json(low);
    accessor["max"] = vector_json(high);
  }

  void add_skins() {
    for (const Skin& skin : scene_.skins) {
      const std::span<const glm::mat4> matrices(skin.joint_from_mesh);
      add_to("skins", {{"name", skin.name},
                       {"joints", skin.joints},
                       {"inverseBindMatrices", add_array(matrices, kFloat, "MAT4")}});
    }
  }

  void add_cameras() {
    for (const Camera& camera : scene_.cameras)
      add_to("cameras",
             {{"name", camera.name},
              {"type", "perspective"},
              {"perspective", {{"yfov", camera.vertical_fov_rad}, {"znear", camera.near_m}}}});
  }

  void add_lights() {
    if (scene_.lights.empty()) return;
    use_extension("KHR_lights_punctual");
    Json lights = Json::array();
    for (const Light& light : scene_.lights) {
      Json object = {{"name", light.name},
                     {"type", light.kind == LightKind::point  ? "point"
                              : light.kind == LightKind::spot ? "spot"
                                                              : "directional"},
                     {"color", vector_json(light.color)},
                     {"intensity", light.intensity}};
      if (std::isfinite(light.range_m)) object["range"] = light.range_m;
      if (light.kind == LightKind::spot)
        object["spot"] = {{"innerConeAngle", light.inner_cone_rad},
                          {"outerConeAngle", light.outer_cone_rad}};
      lights.push_back(std::move(object));
    }
    json_["extensions"]["KHR_lights_punctual"]["lights"] = std::move(lights);
  }

  void add_nodes() {
    for (const Node& node : scene_.nodes) {
      Json object = {{"name", node.name}};
      if (node.matrix) {
        for (int column = 0; column < 4; ++column)
          for (int row = 0; row < 4; ++row) object["matrix"].push_back((*node.matrix)[column][row]);
      } else {
        set_transform(object, node);
      }
      add_to("nodes", std::move(object));
    }
    for (const MeshInstance& instance : scene_.instances)
      if (mesh_index_[instance.mesh] != kNone) {
        Json& node = node_for(instance.node, "mesh");
        node["mesh"] = mesh_index_[instance.mesh];
        if (instance.skin != kNone) node["skin"] = instance.skin;
        if (!instance.morph_weights.empty()) node["weights"] = instance.morph_weights;
      }
    for (size_t k = 0; k < scene_.cameras.size(); ++k)
      node_for(scene_.cameras[k].node, "camera")["camera"] = k;
    for (size_t k = 0; k < scene_.lights.size(); ++k)
      node_for(scene_.lights[k].node,
               "extensions")["extensions"]["KHR_lights_punctual"] = {{"light", k}};
    link_nodes();
  }

  static void set_transform(Json& object, const Node& node) {
    if (node.translation != glm::vec3(0.0f)) object["translation"] = vector_json(node.translation);
    const glm::quat q = node.rotation;
    if (q != glm::quat(1, 0, 0, 0)) object["rotation"] = Json::array({q.x, q.y, q.z, q.w});
    if (node.scale != glm::vec3(1.0f)) object["scale"] = vector_json(node.scale);
  }

  // The node itself if its slot is free, else a new child of it.
  Json& node_for(int32_t node, const char* slot) {
    if (!json_["nodes"][node].contains(slot)) return json_["nodes"][node];
    extra_children_.emplace_back(node, add_to("nodes", {{"name", scene_.nodes[node].name}}));
    return json_["nodes"].back();
  }

  void link_nodes() {
    Json scene = {{"name", scene_.name}};
    for (size_t k = 0; k < scene_.nodes.size(); ++k) {
      const int32_t parent = scene_.nodes[k].parent;
      (parent == kNone ? scene["nodes"] : json_["nodes"][parent]["children"]).push_back(k);
    }
    for (const auto& [parent, child] : extra_children_)
      json_["nodes"][parent]["children"].push_back(child);
    add_to("scenes", std::move(scene));
    json_["scene"] = 0;
  }

  void add_animation() {
    if (scene_.animation.empty()) return;
    Json samplers = Json::array(), channels = Json::array();
    for (const AnimationChannel& channel : scene_.animation) {
      if (channel.path == AnimationPath::morph_weight) continue;
      const std::span<const float> times(channel.times_s);
      const bool is_rotation = channel.path == AnimationPath::rotation;
      std::vector<float> values;
      for (const glm::vec4& v : channel.values)
        for (int c = 0; c < (is_rotation ? 4 : 3); ++c) values.push_back(v[c]);
      const int view = add_view(bytes_of(std::span<const float>(values)));
      const int output =
          add_accessor(view, 0, kFloat, is_rotation ? "VEC4" : "VEC3", channel.values.size());
      const char* path = is_rotation                                  ? "rotation"
                         : channel.path == AnimationPath::translation ? "translation"
                                                                      : "scale";
      channels.push_back(
          {{"sampler", samplers.size()}, {"target", {{"node", channel.node}, {"path", path}}}});
      samplers.push_back(sampler_json(channel, add_times(times), output));
    }
    add_morph_animation(samplers, channels);
    if (!channels.empty())
      add_to("animations", {{"samplers", std::move(samplers)}, {"channels", std::move(channels)}});
  }

  int add_times(std::span<const float> times) {
    const int input = add_accessor(add_view(bytes_of(times)), 0, kFloat, "SCALAR", times.size());
    json_["accessors"][input]["min"] = {times.front()};
    json_["accessors"][input]["max"] = {times.back()};
    return input;
  }

  static Json sampler_json(const AnimationChannel& channel, int input, int output) {
    const char* name = channel.interpolation == Interpolation::step     ? "STEP"
                       : channel.interpolation == Interpolation::linear ? "LINEAR"
                                                                        : "CUBICSPLINE";
    return {{"input", input}, {"output", output}, {"interpolation", name}};
  }

  // glTF keeps the weights of all targets of a node in one sampler: it is made of the node's
  // channels, which the loader has taken apart.
  void add_morph_animation(Json& samplers, Json& channels) {
    std::map<int32_t, std::vector<const AnimationChannel*>> by_node;
    for (const AnimationChannel& channel : scene_.animation)
      if (channel.path == AnimationPath::morph_weight) by_node[channel.node].push_back(&channel);
    for (auto& [node, of_node] : by_node) {
      std::sort(of_node.begin(), of_node.end(),
                [](const auto* a, const auto* b) { return a->morph_target < b->morph_target; });
      const AnimationChannel& first = *of_node.front();
      std::vector<float> values;
      for (size_t i = 0; i < first.values.size(); ++i)
        for (const AnimationChannel* channel : of_node) {
          LUEUR_CHECK_OP(channel->values.size(), ==, first.values.size());
          values.push_back(channel->values[i].x);
        }
      const int output = add_array(std::span<const float>(values), kFloat, "SCALAR");
      channels.push_back(
          {{"sampler", samplers.size()}, {"target", {{"node", node}, {"path", "weights"}}}});
      samplers.push_back(sampler_json(first, add_times(first.times_s), output));
    }
  }

  // Header, JSON chunk padded with spaces, binary chunk padded with zeros.
  Result<std::vector<uint8_t>> assemble() {
    buffer_.resize((buffer_.size() + 3) / 4 * 4);
    if (!buffer_.empty()) add_to("buffers", {{"byteLength", buffer_.size()}});
    std::string text = json_.dump(-1, ' ', false, Json::error_handler_t::replace);
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const size_t total = 12 + 8 + text.size() + (buffer_.empty() ? 0 : 8 + buffer_.size());
    if (total > std::numeric_limits<uint32_t>::max())
      return Error{ErrorKind::output, "scene '" + scene_.name + "' needs " + std::to_string(total) +
                                          " bytes as GLB, which allows 4 GiB; export less of it"};
    std::vector<uint8_t> file;
    file.reserve(total);
    const auto put = [&](size_t value) {
      const auto bytes = std::bit_cast<std::array<uint8_t, 4>>(uint32_t(value));
      file.insert(file.end(), bytes.begin(), bytes.end());
    };
    put(0x46546c67);  // "glTF"
    put(2);
    put(total);
    put(text.size());
    put(0x4e4f534a);  // "JSON"
    file.insert(file.end(), text.begin(), text.end());
    if (buffer_.empty()) return file;
    put(buffer_.size());
    put(0x004e4942);  // "BIN"
    file.insert(file.end(), buffer_.begin(), buffer_.end());
    return file;
  }

  const Scene& scene_;
  Json json_;
  std::vector<uint8_t> buffer_;
  std::vector<int> mesh_index_;  // of each of the scene's meshes, kNone where it has no triangles
  std::vector<std::pair<int, int>> extra_children_;  // parent and child
};

}  // namespace

Result<void> export_glb(const Scene& scene, const std::filesystem::path& path) {
  try {
    LUEUR_TRY(file, GlbWriter(scene).write());
    return write_file(path, std::span<const uint8_t>(file));
  } catch (const std::bad_alloc&) {
    return Error{ErrorKind::memory, path.string() + ": not enough memory to export the scene"};
  }
}

}  // namespace lueur
