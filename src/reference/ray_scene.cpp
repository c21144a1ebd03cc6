// SPDX-License-Identifier: MIT
#include "reference/ray_scene.h"

#include <embree3/rtcore.h>

#include <limits>

#include "base/check.h"
#include "reference/texture.h"

namespace lueur::reference {
namespace {

// What a filter needs to know of a part to find the holes in it.
struct Mask {
  const Part* part = nullptr;
  const Mesh* mesh = nullptr;
  const Material* material = nullptr;
  std::optional<TextureSampler> base_color;
};

// The alpha that a rasterizer's test would see, from the finest level of the texture.
float alpha_at(const Mask& mask, uint32_t triangle, float u, float v) {
  const uint32_t* index = &mask.mesh->indices[mask.part->first_index + 3 * size_t{triangle}];
  const auto& vertices = mask.mesh->vertices;
  const Vertex &a = vertices[index[0]], &b = vertices[index[1]], &c = vertices[index[2]];
  const float w = 1.0f - u - v;
  const float alpha =
      mask.material->base_color.a * (w * color_of(a).a + u * color_of(b).a + v * color_of(c).a);
  if (!mask.base_color) return alpha;
  const glm::vec2 place =
      texture_place(mask.material->base_color_texture, w * a.uv + u * b.uv + v * c.uv,
                    w * a.uv_2 + u * b.uv_2 + v * c.uv_2);
  return alpha * mask.base_color->finest(place).a;
}

bool is_hole_in(const Mask& mask, uint32_t triangle, float u, float v) {
  return alpha_at(mask, triangle, u, v) < mask.material->alpha_cutoff;
}

// Embree calls filters with single rays only, as it gets nothing else from us.
void pass_holes(const RTCFilterFunctionNArguments* args) {
  const Mask& mask = *static_cast<const Mask*>(args->geometryUserPtr);
  const auto* hit = reinterpret_cast<const RTCHit*>(args->hit);
  if (is_hole_in(mask, hit->primID, hit->u, hit->v)) args->valid[0] = 0;
}

// A context that knows the scene, for the filter that only camera rays have.
struct CameraContext {
  RTCIntersectContext base;
  const std::vector<Part>* parts;
  const Scene* scene;
};

void pass_back_faces(const RTCFilterFunctionNArguments* args) {
  const auto* context = reinterpret_cast<const CameraContext*>(args->context);
  const auto* ray = reinterpret_cast<const RTCRay*>(args->ray);
  const auto* hit = reinterpret_cast<const RTCHit*>(args->hit);
  const Part& part = (*context->parts)[hit->geomID];
  if (context->scene->materials[static_cast<size_t>(part.material)].double_sided) return;
  const float along = ray->dir_x * hit->Ng_x + ray->dir_y * hit->Ng_y + ray->dir_z * hit->Ng_z;
  if ((along > 0.0f) != part.mirrored) args->valid[0] = 0;
}

RTCRay embree_ray(const Ray& ray, float far) {
  RTCRay r{};
  r.org_x = ray.origin.x;
  r.org_y = ray.origin.y;
  r.org_z = ray.origin.z;
  r.dir_x = ray.direction.x;
  r.dir_y = ray.direction.y;
  r.dir_z = ray.direction.z;
  r.tfar = far;
  r.mask = ~0u;
  return r;
}

struct Release {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};

}  // namespace

struct RayScene::State {
  const Scene* scene = nullptr;
  std::vector<Part> parts;
  std::vector<std::vector<glm::vec3>> positions;  // world space, by instance
  std::vector<std::unique_ptr<Mask>> masks;
  std::unique_ptr<RTCDeviceTy, Release> device;
  std::unique_ptr<RTCSceneTy, Release> embree;

  void add_instance(uint32_t instance, const glm::mat4& world);
  void add_part(const Part& part);
  CameraContext camera_context() const {
    CameraContext context{{}, &parts, scene};
    rtcInitIntersectContext(&context.base);
    context.base.filter = pass_back_faces;
    return context;
  }
  std::optional<Hit> nearest(const Ray& ray, RTCIntersectContext& context) const;
};

void RayScene::State::add_instance(uint32_t instance, const glm::mat4& world) {
  const MeshInstance& placed = scene->instances[instance];
  const Mesh& mesh = scene->meshes[static_cast<size_t>(placed.mesh)];
  std::vector<glm::vec3>& world_positions = positions[instance];
  // Embree reads 16 bytes from where the last position begins.
  world_positions.reserve(mesh.vertices.size() + 1);
  for (const Vertex& vertex : mesh.vertices)
    world_positions.emplace_back(world * glm::vec4(vertex.position, 1.0f));
  world_positions.emplace_back(0.0f);
  for (const Primitive& primitive : mesh.primitives)
    if (primitive.index_count >= 3)
      add_part({placed.mesh, primitive.material, primitive.first_index, primitive.index_count / 3,
                instance, glm::determinant(glm::mat3(world)) < 0.0f});
}

void RayScene::State::add_part(const Part& part) {
  const Mesh& mesh = scene->meshes[static_cast<size_t>(part.mesh)];
  const RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                             positions[part.instance].data(), 0, sizeof(glm::vec3),
                             mesh.vertices.size());
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                             mesh.indices.data() + part.first_index, 0, 3 * sizeof(uint32_t),
                             part.triangle_count);
  const Material& material = scene->materials[static_cast<size_t>(part.material)];
  if (material.alpha_mode == AlphaMode::mask) {
    auto mask = std::make_unique<Mask>();
    mask->mesh = &mesh;
    mask->material = &material;
    if (material.base_color_texture.is_used())
      mask->base_color.emplace(
          scene->textures[static_cast<size_t>(material.base_color_texture.texture)],
          TextureSampler::Encoding::srgb);
    rtcSetGeometryUserData(geometry, mask.get());
    rtcSetGeometryIntersectFilterFunction(geometry, pass_holes);
    rtcSetGeometryOccludedFilterFunction(geometry, pass_holes);
    masks.push_back(std::move(mask));
  } else {
    masks.emplace_back();
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(embree.get(), geometry, static_cast<unsigned>(parts.size()));
  rtcReleaseGeometry(geometry);
  parts.push_back(part);
}

std::optional<Hit> RayScene::State::nearest(const Ray& ray, RTCIntersectContext& context) const {
  RTCRayHit query{embree_ray(ray, std::numeric_limits<float>::infinity()), {}};
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(embree.get(), &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  const glm::vec3 normal =
      glm::normalize(glm::vec3(query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z));
  return Hit{query.hit.geomID, query.hit.primID,
             query.hit.u,      query.hit.v,
             query.ray.tfar,   parts[query.hit.geomID].mirrored ? -normal : normal};
}

RayScene::RayScene(std::unique_ptr<State> state) : state_(std::move(state)) {}
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;
RayScene::~RayScene() = default;

Result<RayScene> RayScene::create(const Scene& scene,
                                  const std::vector<glm::mat4>& world_from_node) {
  auto state = std::make_unique<State>();
  state->scene = &scene;
  state->device.reset(rtcNewDevice(nullptr));
  const auto failure = [&] {
    return Error{ErrorKind::memory, "scene '" + scene.name +
                                        "': its triangles do not fit into memory for ray tracing; "
                                        "use a smaller scene or a machine with more memory"};
  };
  if (!state->device) return failure();
  state->embree.reset(rtcNewScene(state->device.get()));
  rtcSetSceneFlags(
      state->embree.get(),
      static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
  rtcSetSceneBuildQuality(state->embree.get(), RTC_BUILD_QUALITY_HIGH);
  state->positions.resize(scene.instances.size());
  for (uint32_t i = 0; i < scene.instances.size(); ++i)
    state->add_instance(i, world_from_node[static_cast<size_t>(scene.instances[i].node)]);
  // The parts stand still from here on, and masks may point at them.
  for (size_t i = 0; i < state->parts.size(); ++i)
    if (state->masks[i]) state->masks[i]->part = &state->parts[i];
  rtcCommitScene(state->embree.get());
  if (rtcGetDeviceError(state->device.get()) != RTC_ERROR_NONE) return failure();
  return RayScene(std::move(state));
}

std::optional<Hit> RayScene::nearest(const Ray& ray) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  return state_->nearest(ray, context);
}

std::optional<Hit> RayScene::nearest_for_camera(const Ray& ray) const {
  CameraContext context = state_->camera_context();
  return state_->nearest(ray, context.base);
}

bool RayScene::is_blocked(const Ray& ray, float distance) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay query = embree_ray(ray, distance);
  rtcOccluded1(state_->embree.get(), &context, &query);
  return query.tfar < 0.0f;
}

bool RayScene::is_blocked_for_camera(const Ray& ray, float distance) const {
  CameraContext context = state_->camera_context();
  RTCRay query = embree_ray(ray, distance);
  rtcOccluded1(state_->embree.get(), &context.base, &query);
  return query.tfar < 0.0f;
}

bool RayScene::is_hole(uint32_t part, uint32_t triangle, float u, float v) const {
  const std::unique_ptr<Mask>& mask = state_->masks[part];
  return mask && is_hole_in(*mask, triangle, u, v);
}

const std::vector<Part>& RayScene::parts() const {
  return state_->parts;
}

RayScene::Corners RayScene::corners(uint32_t part, uint32_t triangle) const {
  const Part& p = state_->parts[part];
  const Mesh& mesh = state_->scene->meshes[static_cast<size_t>(p.mesh)];
  const uint32_t* index = &mesh.indices[p.first_index + 3 * size_t{triangle}];
  const std::vector<glm::vec3>& positions = state_->positions[p.instance];
  return {positions[index[0]], positions[index[1]], positions[index[2]]};
}

const Scene& RayScene::scene() const {
  return *state_->scene;
}

}  // namespace lueur::reference
