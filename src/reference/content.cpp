// SPDX-License-Identifier: MIT
#include "reference/content.h"

#include <xxhash.h>

#include <algorithm>
#include <array>
#include <memory>
#include <span>

#include "scene/deform.h"

namespace lueur::reference {
namespace {

// Counted up by each change after which the same scene and settings give other samples.
constexpr uint32_t kVersion = 4;

class Hash {
 public:
  Hash() : state_(XXH3_createState(), &XXH3_freeState) { XXH3_128bits_reset(state_.get()); }

  // Values whose bytes are all theirs: no padding, no pointers.
  template <class T>
  void add(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    XXH3_128bits_update(state_.get(), &value, sizeof(value));
  }
  template <class T>
  void add_all(std::span<const T> values) {
    static_assert(std::is_trivially_copyable_v<T>);
    add(uint64_t{values.size()});
    XXH3_128bits_update(state_.get(), values.data(), values.size_bytes());
  }
  void add(const Material& m);
  void add(const TextureUse& use);
  void add(const Texture& t);
  void add(const Mesh& m);
  void add(const Light& l);

  std::string digits() const {
    XXH128_canonical_t canonical;
    XXH128_canonicalFromHash(&canonical, XXH3_128bits_digest(state_.get()));
    constexpr char kDigits[] = "0123456789abcdef";
    std::string text;
    for (const unsigned char byte : canonical.digest) {
      text += kDigits[byte >> 4];
      text += kDigits[byte & 15];
    }
    return text;
  }

 private:
  std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state_;
};

void Hash::add(const Material& m) {
  add(m.base_color);
  add(std::array{m.metallic, m.roughness, m.specular, m.normal_scale, m.alpha_cutoff});
  add(m.emission);
  for (const TextureUse* use : {&m.base_color_texture, &m.metallic_roughness_texture,
                                &m.normal_texture, &m.emission_texture})
    add(*use);
  add(std::array{m.alpha_mode == AlphaMode::mask, m.double_sided, m.unlit, m.phong.has_value()});
  if (!m.phong) return;
  add(m.phong->color);
  add(std::array{m.phong->exponent, m.phong->c_xy, m.phong->c_z});
}

void Hash::add(const TextureUse& use) {
  add(use.texture);
  add(use.uv_set);
  add(use.transform);
}

void Hash::add(const Texture& t) {
  add(std::array{t.width, t.height});
  add(std::array{t.wrap_u, t.wrap_v});
  add(t.nearest);
  add_all(std::span(t.rgba));
}

void Hash::add(const Mesh& m) {
  static_assert(sizeof(Vertex) == 16 * sizeof(float) && sizeof(Primitive) == 3 * sizeof(uint32_t));
  add_all(std::span(m.vertices));
  add_all(std::span(m.indices));
  add_all(std::span(m.primitives));
}

void Hash::add(const Light& l) {
  add(l.kind);
  add(l.node);
  add(l.color);
  add(std::array{l.intensity, l.inner_cone_rad, l.outer_cone_rad, l.range_m});
}

// `scene` without skins and morph targets.
Hash hash_of_rigid(const Scene& scene, const Shot& shot, const Settings& settings) {
  Hash hash;
  hash.add(kVersion);
  // Lengths first, so that what ends one list never reads as the beginning of the next.
  hash.add(std::array{uint64_t{scene.textures.size()}, uint64_t{scene.materials.size()},
                      uint64_t{scene.meshes.size()}, uint64_t{scene.instances.size()},
                      uint64_t{scene.lights.size()}});
  for (const Texture& texture : scene.textures) hash.add(texture);
  for (const Material& material : scene.materials) hash.add(material);
  for (const Mesh& mesh : scene.meshes) hash.add(mesh);
  for (const MeshInstance& instance : scene.instances)
    hash.add(std::array{instance.node, instance.mesh});
  for (const Light& light : scene.lights) hash.add(light);
  hash.add_all(std::span<const glm::mat4>(pose(scene, shot.time_s)));
  const Camera& camera = scene.cameras[static_cast<size_t>(shot.camera)];
  hash.add(camera.node);
  hash.add(std::array{camera.vertical_fov_rad, camera.near_m});
  hash.add(std::array{shot.width, shot.height});
  hash.add(std::array{static_cast<uint32_t>(settings.mode), settings.bounces, settings.seed,
                      static_cast<uint32_t>(settings.form_factor)});
  hash.add(settings.ambient_distance_m);
  // How many lights there are says where each is.
  if (settings.mode == Mode::lights || settings.mode == Mode::lights_unoccluded)
    hash.add(settings.spp);
  // Only where there is one: other scenes keep their names.
  if (const auto& environment = scene.environment) {
    hash.add(std::array{environment->width, environment->height});
    hash.add(std::array{environment->rotation_rad, environment->intensity});
    hash.add_all(std::span(environment->rgb));
  }
  return hash;
}

Hash hash_of(const Scene& scene, const Shot& shot, const Settings& settings) {
  // What skins and morph targets do at the shot's time counts, not how they do it.
  const auto deforms = [&](const MeshInstance& instance) { return is_deformed(scene, instance); };
  return std::any_of(scene.instances.begin(), scene.instances.end(), deforms)
             ? hash_of_rigid(with_deformed_meshes(scene, shot.time_s), shot, settings)
             : hash_of_rigid(scene, shot, settings);
}

}  // namespace

std::string content_key(const Scene& scene, const Shot& shot, const Settings& settings) {
  return hash_of(scene, shot, settings).digits();
}

std::string finished_key(const Scene& scene, const Shot& shot, const Settings& settings) {
  Hash hash = hash_of(scene, shot, settings);
  hash.add(settings.spp);
  hash.add(settings.target_error);
  return hash.digits();
}

}  // namespace lueur::reference
