// SPDX-License-Identifier: MIT
#include "support/gpu_test.h"

#include <glm/gtc/packing.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "shading/packing.h"

namespace lueur {

void GpuTest::SetUp() {
  auto made = gpu::System::create({.validation = true});
  ASSERT_TRUE(made.ok()) << made.error().message;
  system_ = std::move(*made);
  ContextInfo info = system_->context_info();
  info.frames_in_flight = 1;
  info.timers = Timers::passes;
  auto context = Context::create(info);
  ASSERT_TRUE(context.ok()) << context.error().message;
  context_ = std::move(*context);
  recorder().options.scan = true;
}

void GpuTest::TearDown() {
  context_.reset();
  if (!system_) return;
  for (const std::string& message : system_->validation_messages())
    ADD_FAILURE() << "validation: " << message;
}

void GpuTest::run(const std::function<void(Frame&)>& record) {
  const auto result = system_->run([&](VkCommandBuffer commands) {
    Frame frame = context_->record(commands);
    record(frame);
    return frame.finish();
  });
  ASSERT_TRUE(result.ok()) << result.error().message;
  for (const ScanFinding& f : recorder().scan_findings())
    ADD_FAILURE() << f.image << ": " << f.nan << " NaN, " << f.infinite << " infinite, "
                  << f.negative << " negative pixels, first at " << f.first_x << ", " << f.first_y;
}

Pixels GpuTest::pixels(const std::string& name) {
  for (Pixels& p : recorder().read_back_pixels())
    if (p.name == name) return std::move(p);
  ADD_FAILURE() << "nothing was read back as " << name;
  return {};
}

GBuffer CpuGBuffer::upload(Recorder& recorder) const {
  std::vector<glm::vec4> packed_normal, packed_source;
  for (const glm::vec3& n : normal) packed_normal.emplace_back(octahedral_encode(n), 0, 0);
  for (const glm::vec3& s : source) packed_source.emplace_back(s, 1);
  GBuffer g{
      .depth = recorder.upload_image("depth", extent, Format::r32f, depth.data()),
      .normal = recorder.upload_image("normal", extent, Format::rgba32f, packed_normal.data()),
      .source = recorder.upload_image("source", extent, Format::rgba32f, packed_source.data())};
  std::vector<glm::vec4> packed_motion;
  for (const glm::vec2& m : motion) packed_motion.emplace_back(m, 0, 0);
  if (!motion.empty())
    g.motion = recorder.upload_image("motion", extent, Format::rgba32f, packed_motion.data());
  std::vector<uint64_t> packed_albedo, packed_reflectance;
  for (const glm::vec3& a : albedo) packed_albedo.push_back(glm::packHalf4x16(glm::vec4(a, 1)));
  for (const glm::vec4& r : reflectance) packed_reflectance.push_back(glm::packHalf4x16(r));
  if (!albedo.empty())
    g.albedo = recorder.upload_image("albedo", extent, Format::rgba16f, packed_albedo.data());
  if (!reflectance.empty())
    g.reflectance =
        recorder.upload_image("reflectance", extent, Format::rgba16f, packed_reflectance.data());
  return g;
}

CpuGBuffer cast_g_buffer(const CpuScene& scene, Extent extent, double vertical_fov_rad,
                         const glm::dvec3& eye, const glm::dmat3& turn) {
  constexpr double kNear = 0.01;
  const double tan_v = std::tan(0.5 * vertical_fov_rad);
  const double tan_h = tan_v * extent.width / extent.height;
  CpuGBuffer g;
  g.extent = extent;
  glm::dmat4 world_from_view(turn);
  world_from_view[3] = glm::dvec4(eye, 1.0);
  const glm::mat4 view_from_world(glm::inverse(world_from_view));
  std::copy_n(glm::value_ptr(view_from_world), 16, g.view.view_from_world.begin());
  g.view.clip_from_view[0] = static_cast<float>(1.0 / tan_h);
  g.view.clip_from_view[5] = static_cast<float>(-1.0 / tan_v);
  g.view.clip_from_view[11] = -1.0f;
  g.view.clip_from_view[14] = static_cast<float>(kNear);

  for (uint32_t y = 0; y < extent.height; ++y) {
    for (uint32_t x = 0; x < extent.width; ++x) {
      const glm::dvec3 ray((2.0 * (x + 0.5) / extent.width - 1.0) * tan_h,
                           (1.0 - 2.0 * (y + 0.5) / extent.height) * tan_v, -1.0);
      const auto hit = scene(eye, turn * ray);
      const glm::dvec3 in_view =
          hit ? glm::transpose(turn) * (hit->position - eye) : glm::dvec3(0.0);
      g.position_view.push_back(in_view);
      g.depth.push_back(hit ? static_cast<float>(kNear / -in_view.z) : 0.0f);
      g.normal.push_back(hit ? glm::vec3(hit->normal) : glm::vec3(0, 0, 1));
      g.source.push_back(hit ? glm::vec3(hit->radiance) : glm::vec3(0));
    }
  }
  return g;
}

glm::dmat4 world_from_view(const View& view) {
  return glm::inverse(glm::dmat4(glm::make_mat4(view.view_from_world.data())));
}

CpuGBuffer seen_through(const CpuScene& scene, const View& view, Extent extent) {
  const glm::dmat4 m = world_from_view(view);
  const double fov = 2 * std::atan(1 / std::abs(double{view.clip_from_view[5]}));
  CpuGBuffer g = cast_g_buffer(scene, extent, fov, glm::dvec3(m[3]), glm::dmat3(m));
  for (float& d : g.depth) d *= view.clip_from_view[14] / g.view.clip_from_view[14];
  g.view = view;
  return g;
}

}  // namespace lueur
