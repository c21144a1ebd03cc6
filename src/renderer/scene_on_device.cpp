// SPDX-License-Identifier: MIT
#include "renderer/scene_on_device.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <span>

#include "base/try.h"
#include "image/mip_chain.h"
#include "renderer/upload.h"
#include "scene/watertight.h"

namespace lueur {
namespace {

enum class Encoding { srgb, linear };

// Which of the scene's textures some material uses with this encoding.
std::vector<bool> used_textures(const Scene& scene, Encoding encoding) {
  std::vector<bool> used(scene.textures.size(), false);
  const auto mark = [&](const TextureUse& use) {
    if (use.is_used()) used[static_cast<size_t>(use.texture)] = true;
  };
  for (const Material& m : scene.materials) {
    if (encoding == Encoding::srgb) {
      mark(m.base_color_texture);
      mark(m.emission_texture);
    } else {
      mark(m.metallic_roughness_texture);
      mark(m.normal_texture);
    }
  }
  return used;
}

Result<gpu::Texture> upload_texture(Uploader& uploader, gpu::Device& device,
                                    const std::string& name, Extent extent,
                                    const std::vector<uint8_t>& rgba, Encoding encoding) {
  const auto smaller =
      make_mip_chain(rgba, extent.width, extent.height, encoding == Encoding::srgb);
  std::vector<std::span<const uint8_t>> levels{rgba};
  std::vector<Extent> extents{extent};
  for (const MipLevel& level : smaller) {
    levels.emplace_back(level.rgba);
    extents.push_back({level.width, level.height});
  }
  LUEUR_TRY(texture,
            gpu::Texture::create(
                device, {.name = name,
                         .extent = extent,
                         .format = encoding == Encoding::srgb ? Format::rgba8_srgb : Format::rgba8,
                         .usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                         .mip_levels = static_cast<uint32_t>(levels.size())}));
  LUEUR_TRY_VOID(uploader.to_texture(levels, extents, texture));
  return std::move(texture);
}

gpu::Address address(Wrap wrap) {
  switch (wrap) {
    case Wrap::repeat:
      return gpu::Address::repeat;
    case Wrap::clamp_to_edge:
      return gpu::Address::clamp_to_edge;
    case Wrap::mirrored_repeat:
      return gpu::Address::mirrored_repeat;
  }
  return gpu::Address::repeat;
}

TexturePlacement placement(const TextureUse& use) {
  return {use.transform[0], use.transform[1], use.transform[2], use.uv_set};
}

// The instance's vertices at that time; empty where nothing deforms it.
std::span<const Vertex> vertices_of(const ScenePose& pose, size_t instance) {
  for (const DeformedInstance& deformed : pose.deformed)
    if (deformed.instance == instance) return deformed.vertices;
  return {};
}

bool is_mirrored(const glm::mat4& m) {
  return glm::determinant(glm::mat3(m)) < 0.0f;
}

}  // namespace

std::vector<gpu::VertexAttribute> g_buffer_attributes() {
  return {{VK_FORMAT_R32G32B32_SFLOAT, offsetof(Vertex, position)},
          {VK_FORMAT_R32G32B32_SFLOAT, offsetof(Vertex, normal)},
          {VK_FORMAT_R32G32B32A32_SFLOAT, offsetof(Vertex, tangent)},
          {VK_FORMAT_R32G32_SFLOAT, offsetof(Vertex, uv)},
          {VK_FORMAT_R32G32_SFLOAT, offsetof(Vertex, uv_2)},
          {VK_FORMAT_R16G16B16A16_UNORM, offsetof(Vertex, color)}};
}

std::vector<gpu::VertexAttribute> shadow_attributes() {
  return {{VK_FORMAT_R32G32B32_SFLOAT, offsetof(Vertex, position)},
          {VK_FORMAT_R32G32_SFLOAT, offsetof(Vertex, uv)},
          {VK_FORMAT_R32G32_SFLOAT, offsetof(Vertex, uv_2)},
          {VK_FORMAT_R16G16B16A16_UNORM, offsetof(Vertex, color)}};
}

Result<std::unique_ptr<SceneOnDevice>> SceneOnDevice::create(gpu::System& system, Context& context,
                                                             const Scene& scene) {
  std::unique_ptr<SceneOnDevice> result(new SceneOnDevice);
  gpu::Device& device = context.recorder().device();
  result->scene_materials_ = scene.materials;
  result->moving_objects_ = lueur::moving_objects(scene);
  for (size_t i = 0; i < scene.instances.size(); ++i) {
    result->instances_.push_back({scene.instances[i], i});
    result->keeps_light_ |= !scene.instances[i].passes_light_on;
  }
  std::stable_sort(result->instances_.begin(), result->instances_.end(),
                   [](const auto& a, const auto& b) { return a.placed.mesh < b.placed.mesh; });
  LUEUR_TRY_VOID(result->upload_geometry(system, device, scene));
  LUEUR_TRY_VOID(result->upload_textures(system, device, scene));
  result->make_materials(context.recorder(), scene);
  return result;
}

// Puts the triangles of each primitive that bound solids first, the thinnest before the others;
// gives how many indices those have. What has holes by its material bounds nothing.
std::vector<std::vector<SolidPart>> SceneOnDevice::solids_first(const Mesh& mesh,
                                                                std::span<uint32_t> indices) const {
  const Watertightness found = watertightness(mesh);
  std::vector<std::vector<SolidPart>> solids;
  for (const Primitive& primitive : mesh.primitives) {
    const bool has_holes = material(primitive.material).alpha_mode == AlphaMode::mask;
    struct Part {
      std::vector<uint32_t> indices;
      float thickness_m = std::numeric_limits<float>::max();
    };
    std::map<int, Part> parts;  // by power of two of the thickness
    std::vector<uint32_t> open;
    for (uint32_t i = primitive.first_index; i < primitive.first_index + primitive.index_count;
         i += 3) {
      const float thickness_m = found.thickness_m[i / 3];
      std::vector<uint32_t>* where = &open;
      if (!has_holes && thickness_m > 0.0f) {
        Part& part = parts[std::ilogb(thickness_m)];
        part.thickness_m = std::min(part.thickness_m, thickness_m);
        where = &part.indices;
      }
      where->insert(where->end(), &indices[i], &indices[i] + 3);
    }
    auto end = indices.begin() + primitive.first_index;
    solids.emplace_back();
    for (const auto& [power, part] : parts) {
      end = std::copy(part.indices.begin(), part.indices.end(), end);
      solids.back().push_back({static_cast<uint32_t>(part.indices.size()), part.thickness_m});
    }
    std::copy(open.begin(), open.end(), end);
  }
  return solids;
}

Result<void> SceneOnDevice::upload_geometry(gpu::System& system, gpu::Device& device,
                                            const Scene& scene) {
  std::vector<Vertex> vertices;
  std::vector<uint32_t> indices;
  for (const Mesh& mesh : scene.meshes) {
    meshes_.push_back(
        {static_cast<uint32_t>(indices.size()), static_cast<int32_t>(vertices.size())});
    primitives_.push_back(mesh.primitives);
    vertices.insert(vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    indices.insert(indices.end(), mesh.indices.begin(), mesh.indices.end());
    solids_.push_back(solids_first(mesh, std::span(indices).last(mesh.indices.size())));
  }
  // An empty scene still binds something.
  if (vertices.empty()) vertices.emplace_back();
  if (indices.empty()) indices.push_back(0);

  const auto vertex_bytes = std::as_bytes(std::span(vertices));
  const auto index_bytes = std::as_bytes(std::span(indices));
  LUEUR_TRY(vertex_buffer,
            gpu::Buffer::create(device, {.name = "vertices",
                                         .bytes = vertex_bytes.size(),
                                         .usage = VK_BUFFER_USAGE_VERTEX_BUFFER_BIT |
                                                  VK_BUFFER_USAGE_STORAGE_BUFFER_BIT |
                                                  VK_BUFFER_USAGE_TRANSFER_DST_BIT}));
  LUEUR_TRY(index_buffer, gpu::Buffer::create(device, {.name = "indices",
                                                       .bytes = index_bytes.size(),
                                                       .usage = VK_BUFFER_USAGE_INDEX_BUFFER_BIT |
                                                                VK_BUFFER_USAGE_STORAGE_BUFFER_BIT |
                                                                VK_BUFFER_USAGE_TRANSFER_DST_BIT}));
  vertices_ = std::move(vertex_buffer);
  indices_ = std::move(index_buffer);
  Uploader uploader(system, device);
  LUEUR_TRY_VOID(uploader.to_buffer(vertex_bytes, vertices_));
  LUEUR_TRY_VOID(uploader.to_buffer(index_bytes, indices_));
  return uploader.flush();
}

Result<void> SceneOnDevice::upload_textures(gpu::System& system, gpu::Device& device,
                                            const Scene& scene) {
  Uploader uploader(system, device);
  for (const Encoding encoding : {Encoding::srgb, Encoding::linear}) {
    const std::vector<bool> used = used_textures(scene, encoding);
    auto& textures = encoding == Encoding::srgb ? srgb_textures_ : linear_textures_;
    for (size_t i = 0; i < scene.textures.size(); ++i) {
      textures.emplace_back();
      if (!used[i]) continue;
      const Texture& t = scene.textures[i];
      LUEUR_TRY(texture, upload_texture(uploader, device, t.name.empty() ? "texture" : t.name,
                                        {t.width, t.height}, t.rgba, encoding));
      textures.back() = std::move(texture);
    }
  }
  LUEUR_TRY(white, upload_texture(uploader, device, "white", {1, 1}, {255, 255, 255, 255},
                                  Encoding::linear));
  white_ = std::move(white);
  return uploader.flush();
}

void SceneOnDevice::make_materials(Recorder& recorder, const Scene& scene) {
  cosine_lobes_ = lobe_table(scene.materials);
  for (const Material& m : scene.materials) {
    MaterialData data{};
    data.base_color = m.base_color;
    data.emission = m.emission;
    data.metallic = m.metallic;
    data.roughness = m.roughness;
    data.specular = m.phong ? 0.0f : m.specular;
    data.normal_scale = m.normal_scale;
    data.alpha_cutoff = m.alpha_mode == AlphaMode::mask ? m.alpha_cutoff : 0.0f;
    data.has_normal_map = m.normal_texture.is_used();
    data.unlit = m.unlit;
    data.cosine_lobe = cosine_lobes_.of_material[materials_.size()];
    data.base_color_place = placement(m.base_color_texture);
    data.metallic_roughness_place = placement(m.metallic_roughness_texture);
    data.normal_place = placement(m.normal_texture);
    data.emission_place = placement(m.emission_texture);
    materials_.push_back(data);
    emits_ |= m.unlit || glm::any(glm::greaterThan(m.emission, glm::vec3(0.0f)));

    const auto bound = [&](const char* name, const TextureUse& use,
                           const std::vector<gpu::Texture>& from) {
      gpu::SamplerState sampler{.filter = gpu::Filter::linear, .mipmaps = true};
      const gpu::Texture* texture = &white_;
      if (use.is_used()) {
        const Texture& t = scene.textures[static_cast<size_t>(use.texture)];
        texture = &from[static_cast<size_t>(use.texture)];
        sampler.u = address(t.wrap_u);
        sampler.v = address(t.wrap_v);
        if (t.nearest) sampler.filter = gpu::Filter::nearest;
      }
      return Bound{name, SampledTexture{texture}, sampler};
    };
    material_sets_.push_back(recorder.material_set(
        {bound("base_color_texture", m.base_color_texture, srgb_textures_),
         bound("metallic_roughness_texture", m.metallic_roughness_texture, linear_textures_),
         bound("normal_texture", m.normal_texture, linear_textures_),
         bound("emission_texture", m.emission_texture, srgb_textures_)}));
  }
}

FrameGeometry SceneOnDevice::pose(const ScenePose& now, const ScenePose& before) const {
  FrameGeometry frame;
  // A frame without deformed vertices still binds one.
  frame.deformed.emplace_back();
  for (const Instance& instance : instances_) {
    const glm::mat4 world = world_from_instance(instance.placed, now.world_from_node);
    // A transform that flattens has no inverse; its normals are then left as they are.
    const glm::mat3 linear(world);
    const glm::mat3 normal = std::abs(glm::determinant(linear)) > 1e-30f
                                 ? glm::transpose(glm::inverse(linear))
                                 : glm::mat3(1.0f);
    InstanceData data{
        .world_from_object = world,
        .world_from_object_before = world_from_instance(instance.placed, before.world_from_node),
        .world_from_object_normal = normal,
        .is_deformed = 0,
        .first_deformed = 0,
        .surface_bits = instance.placed.passes_light_on ? 0 : kKeepsLight,
        .object = static_cast<uint32_t>(moving_objects_.of_instance[instance.index] + 1)};
    const auto shaped = vertices_of(now, instance.index);
    const auto shaped_before = vertices_of(before, instance.index);
    if (!shaped.empty()) {
      data.is_deformed = 1;
      data.first_deformed = static_cast<int32_t>(frame.deformed.size()) -
                            meshes_[static_cast<size_t>(instance.placed.mesh)].vertex_offset;
      for (size_t i = 0; i < shaped.size(); ++i)
        frame.deformed.push_back({shaped[i].position, shaped_before[i].position, shaped[i].normal,
                                  glm::vec3(shaped[i].tangent)});
    }
    frame.instances.push_back(data);
  }
  frame.draws = draws(now.world_from_node);
  return frame;
}

std::vector<DrawItem> SceneOnDevice::draws(const std::vector<glm::mat4>& world_from_node) const {
  std::vector<DrawItem> items;
  for (uint32_t first = 0; first < instances_.size();) {
    // A run: instances of one mesh that are mirrored alike.
    const int32_t mesh = instances_[first].placed.mesh;
    const auto mirrored_at = [&](uint32_t i) {
      return is_mirrored(world_from_instance(instances_[i].placed, world_from_node));
    };
    uint32_t end = first + 1;
    while (end < instances_.size() && instances_[end].placed.mesh == mesh &&
           mirrored_at(end) == mirrored_at(first))
      ++end;
    const MeshRange& range = meshes_[static_cast<size_t>(mesh)];
    const auto& primitives = primitives_[static_cast<size_t>(mesh)];
    for (size_t i = 0; i < primitives.size(); ++i)
      items.push_back({range.first_index + primitives[i].first_index, primitives[i].index_count,
                       range.vertex_offset, first, end - first, primitives[i].material,
                       mirrored_at(first), solids_[static_cast<size_t>(mesh)][i]});
    first = end;
  }
  return items;
}

}  // namespace lueur
