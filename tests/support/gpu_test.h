// SPDX-License-Identifier: MIT
// A device with validation for tests: any message of the core or synchronization layers fails the
// test that caused it.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <glm/glm.hpp>
#include <numbers>
#include <optional>

#include "frame/recorder.h"
#include "gpu/system.h"
#include "lueur/technique.h"

namespace lueur {

inline constexpr double kPi = std::numbers::pi;

class GpuTest : public testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;

  // Records one frame, runs it, and fails the test if anything fails.
  void run(const std::function<void(Frame&)>& record);
  Recorder& recorder() { return context_->recorder(); }
  gpu::System& system() { return *system_; }
  Context& context() { return *context_; }
  // Pixels read back under this name in the last frame.
  Pixels pixels(const std::string& name);

 private:
  std::unique_ptr<gpu::System> system_;
  std::optional<Context> context_;
};

// What a camera sees, made on the CPU.
struct CpuGBuffer {
  Extent extent;
  View view;
  std::vector<float> depth;       // as the projection yields it
  std::vector<glm::vec3> normal;  // world
  std::vector<glm::vec3> source;  // radiance
  std::vector<glm::dvec3> position_view;
  // Where empty, the G-buffer goes without that image.
  std::vector<glm::vec2> motion;
  std::vector<glm::vec3> albedo;
  std::vector<glm::vec4> reflectance;

  // Uploads it in float formats, so that nothing is lost on the way in, but for the last two, which
  // have to be half floats.
  GBuffer upload(Recorder& recorder) const;
};

// A surface hit along a ray from the camera.
struct CpuHit {
  glm::dvec3 position;  // world
  glm::dvec3 normal;
  glm::dvec3 radiance;
};
using CpuScene =
    std::function<std::optional<CpuHit>(const glm::dvec3& origin, const glm::dvec3& direction)>;

// Casts a ray through each pixel's centre. The camera stands at `eye`, looks along -z turned by
// `turn` (world from view).
CpuGBuffer cast_g_buffer(const CpuScene& scene, Extent extent, double vertical_fov_rad,
                         const glm::dvec3& eye, const glm::dmat3& turn = glm::dmat3(1.0));

glm::dmat4 world_from_view(const View& view);
// What a view with a symmetric frustum sees of a scene.
CpuGBuffer seen_through(const CpuScene& scene, const View& view, Extent extent);

}  // namespace lueur
