// SPDX-License-Identifier: MIT
#include "techniques/hierarchical/box_fixture.h"

#include <cmath>

namespace lueur {
namespace {

// Where a ray enters a box.
std::optional<CpuHit> enter(const SolidBox& box, const glm::dvec3& o, const glm::dvec3& d) {
  double near = 1e-9, far = 1e30;
  glm::dvec3 normal(0);
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (double{box.low[axis]} - o[axis]) / d[axis];
    const double b = (double{box.high[axis]} - o[axis]) / d[axis];
    if (std::min(a, b) > near) {
      near = std::min(a, b);
      normal = glm::dvec3(0);
      normal[axis] = d[axis] > 0 ? -1 : 1;
    }
    far = std::min(far, std::max(a, b));
  }
  if (near >= far || normal == glm::dvec3(0)) return std::nullopt;
  return CpuHit{o + near * d, normal, glm::dvec3(box.radiance)};
}

}  // namespace

CpuScene scene_of(std::vector<SolidBox> boxes) {
  return [boxes = std::move(boxes)](const glm::dvec3& o, const glm::dvec3& d) {
    std::optional<CpuHit> nearest;
    for (const SolidBox& box : boxes) {
      const auto hit = enter(box, o, d);
      if (hit && (!nearest || glm::length(hit->position - o) < glm::length(nearest->position - o)))
        nearest = hit;
    }
    return nearest;
  };
}

BoxHost::BoxHost(const std::vector<SolidBox>& boxes, std::vector<PunctualLight> lights)
    : scene_(scene_of(boxes)), lights_(std::move(lights)) {
  for (const SolidBox& box : boxes) {
    const auto first = static_cast<uint32_t>(positions_.size());
    for (uint32_t corner = 0; corner < 8; ++corner)
      positions_.push_back({corner & 1 ? box.high.x : box.low.x,
                            corner & 2 ? box.high.y : box.low.y,
                            corner & 4 ? box.high.z : box.low.z});
    for (const uint32_t corner : {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                                  2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6})
      indices_.push_back(first + corner);
  }
}

GBuffer BoxHost::render_view(Frame& frame, const View& view, Extent extent, const ViewContent&) {
  return seen_through(scene_, view, extent).upload(frame.recorder());
}

std::span<const TriangleBatch> BoxHost::triangles(Frame& frame) {
  TriangleRange range{.index_count = static_cast<uint32_t>(indices_.size()), .closed = true};
  for (size_t i = 0; i < 16; i += 5) range.world_from_object[i] = 1.0f;
  batch_ = {.vertices = frame.recorder().upload(positions_),
            .indices = frame.recorder().upload(indices_),
            .ranges = {range}};
  return {&batch_, 1};
}

}  // namespace lueur
