// SPDX-License-Identifier: MIT
#include "renderer/renderer_fixture.h"

#include "scene/builtin/scene_builder.h"

namespace lueur {

Scene RendererTest::scene_seen_from(const glm::vec3& eye, const glm::vec3& target) {
  Scene scene;
  builtin::add_camera(scene, "camera", eye, target, 0.8f);
  builtin::add_material(scene, "white", glm::vec3(1.0f), 1.0f);
  return scene;
}

int32_t RendererTest::add_quad(Scene& scene, const glm::vec3& corner, const glm::vec3& u,
                               const glm::vec3& v, int32_t material) {
  const glm::vec3 normal = glm::normalize(glm::cross(u, v));
  const glm::vec4 tangent(glm::normalize(u), 1.0f);
  Mesh mesh;
  mesh.name = "quad";
  mesh.vertices = {{corner, normal, tangent, {0, 0}},
                   {corner + u, normal, tangent, {1, 0}},
                   {corner + u + v, normal, tangent, {1, 1}},
                   {corner + v, normal, tangent, {0, 1}}};
  mesh.indices = {0, 1, 2, 0, 2, 3};
  mesh.primitives = {{0, 6, material}};
  return builtin::add_mesh(scene, std::move(mesh));
}

int32_t RendererTest::add_floor(Scene& scene, float half_side, int32_t material) {
  return add_quad(scene, {-half_side, 0, half_side}, {2 * half_side, 0, 0}, {0, 0, -2 * half_side},
                  material);
}

Light& RendererTest::add_light(Scene& scene, LightKind kind, float intensity,
                               const glm::vec3& position, const glm::vec3& direction) {
  Light light;
  light.kind = kind;
  light.intensity = intensity;
  light.node = builtin::add_node(scene, "light", position, builtin::look_along(direction));
  scene.lights.push_back(light);
  return scene.lights.back();
}

void RendererTest::render(const Scene& scene, const Shot& shot, Technique* technique) {
  images_.clear();
  camera_ = scene.cameras[static_cast<size_t>(shot.camera)];
  extent_ = shot.extent;
  world_from_camera_ = glm::dmat4(pose(scene, shot.time_s)[static_cast<size_t>(camera_.node)]);
  auto renderer = Renderer::create(system(), context(), scene);
  ASSERT_TRUE(renderer.ok()) << renderer.error().message;
  run([&](Frame& frame) {
    const RenderedImages images = (*renderer)->record(frame, shot, technique);
    Recorder& r = frame.recorder();
    r.read_back("depth", images.depth);
    r.read_back("normal", images.normal);
    r.read_back("albedo", images.albedo);
    r.read_back("material", images.material);
    r.read_back("emission", images.emission);
    r.read_back("motion", images.motion);
    r.read_back("source", images.source);
    r.read_back("specular", images.specular);
    r.read_back("indirect", images.indirect);
    r.read_back("composed", images.composed);
  });
  images_ = recorder().read_back_pixels();
}

glm::vec4 RendererTest::at(const std::string& image, const PixelRay& pixel) const {
  for (const Pixels& p : images_) {
    if (p.name != image) continue;
    glm::vec4 value(0.0f);
    for (uint32_t c = 0; c < p.channels; ++c)
      value[static_cast<int>(c)] = p.samples[pixel.index * p.channels + c];
    return value;
  }
  ADD_FAILURE() << "there is no image " << image;
  return {};
}

std::vector<PixelRay> RendererTest::rays() const {
  const double tan_v = std::tan(0.5 * static_cast<double>(camera_.vertical_fov_rad));
  const double tan_h = tan_v * extent_.width / extent_.height;
  std::vector<PixelRay> list;
  for (uint32_t y = 0; y < extent_.height; ++y) {
    for (uint32_t x = 0; x < extent_.width; ++x) {
      const glm::dvec3 in_view((2.0 * (x + 0.5) / extent_.width - 1.0) * tan_h,
                               (1.0 - 2.0 * (y + 0.5) / extent_.height) * tan_v, -1.0);
      list.push_back({x, y, list.size(), glm::dvec3(world_from_camera_[3]),
                      glm::dmat3(world_from_camera_) * in_view});
    }
  }
  return list;
}

std::optional<glm::dvec3> meet_plane(const PixelRay& ray, const glm::dvec3& point,
                                     const glm::dvec3& normal) {
  const double t = glm::dot(point - ray.origin, normal) / glm::dot(ray.direction, normal);
  if (!(t > 0.0) || !std::isfinite(t)) return std::nullopt;
  return ray.origin + t * ray.direction;
}

}  // namespace lueur
