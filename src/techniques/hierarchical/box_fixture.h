// SPDX-License-Identifier: MIT
// Scenes of solid boxes, and an engine that has their triangles.
#pragma once

#include <vector>

#include "techniques/hierarchical/hierarchical_fixture.h"

namespace lueur {

// In world space, axes parallel to the world's.
struct SolidBox {
  glm::vec3 low, high;
  double radiance = 0;  // of all its faces
};

CpuScene scene_of(std::vector<SolidBox> boxes);

// Every light shows the boxes' radiance.
class BoxHost final : public Host {
 public:
  explicit BoxHost(const std::vector<SolidBox>& boxes, std::vector<PunctualLight> lights = {});
  GBuffer render_view(Frame& frame, const View& view, Extent extent,
                      const ViewContent& content) override;
  std::span<const PunctualLight> lights() const override { return lights_; }
  Box bounds() const override { return {{-4, -1, -4}, {4, 4, 4}}; }
  std::span<const TriangleBatch> triangles(Frame& frame) override;

 private:
  CpuScene scene_;
  std::vector<PunctualLight> lights_;
  std::vector<glm::vec3> positions_;
  std::vector<uint32_t> indices_;
  TriangleBatch batch_;
};

}  // namespace lueur
