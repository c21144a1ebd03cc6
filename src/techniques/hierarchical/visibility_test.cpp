// SPDX-License-Identifier: MIT
// Obstacles between what the camera sees: FDP 4, "visibility computation".
#include <cmath>

#include "techniques/hierarchical/hierarchical_fixture.h"

namespace lueur {
namespace {

// A box in world space, as triangles that look outwards.
struct SolidBox {
  glm::vec3 low, high;
};

// An engine that has triangles and nothing else.
class TriangleHost final : public Host {
 public:
  explicit TriangleHost(const std::vector<SolidBox>& boxes) {
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
  GBuffer render_view(Frame&, const View&, Extent, int32_t) override { return {}; }
  std::span<const PunctualLight> lights() const override { return {}; }
  Box bounds() const override { return {}; }
  std::span<const TriangleBatch> triangles(Frame& frame) override {
    TriangleRange range{.index_count = static_cast<uint32_t>(indices_.size()), .closed = true};
    for (size_t i = 0; i < 16; i += 5) range.world_from_object[i] = 1.0f;
    batch_ = {.vertices = frame.recorder().upload(positions_),
              .indices = frame.recorder().upload(indices_),
              .ranges = {range}};
    return {&batch_, 1};
  }

 private:
  std::vector<glm::vec3> positions_;
  std::vector<uint32_t> indices_;
  TriangleBatch batch_;
};

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
  return CpuHit{o + near * d, normal, glm::dvec3(0)};
}

// A floor, seen from above, a glowing box at its left and, where asked for, a wall across its
// middle.
const SolidBox kFloor{{-3, -0.5f, -3}, {3, 0, 3}};
const SolidBox kLamp{{-2.6f, 0, -1}, {-2.2f, 0.8f, 1}};
const SolidBox kWall{{-0.2f, 0, -2.9f}, {0.2f, 1.6f, 2.9f}};

class VisibilityTest : public HierarchicalTest {
 protected:
  struct Room {
    std::vector<SolidBox> boxes;
    CpuGBuffer g;
  };
  static Room room(bool with_wall) {
    Room r{{kFloor, kLamp}, {}};
    if (with_wall) r.boxes.push_back(kWall);
    const glm::dmat3 down(1, 0, 0, 0, 0.2, -std::sqrt(0.96), 0, std::sqrt(0.96), 0.2);
    r.g = cast_g_buffer(
        [&](const glm::dvec3& o, const glm::dvec3& d) {
          std::optional<CpuHit> nearest;
          for (const SolidBox& box : r.boxes) {
            auto hit = enter(box, o, d);
            if (!hit ||
                (nearest && glm::length(hit->position - o) > glm::length(nearest->position - o)))
              continue;
            if (&box == &r.boxes[1]) hit->radiance = glm::dvec3(1);
            nearest = hit;
          }
          return nearest;
        },
        {192, 128}, 0.9, {0, 7, 1.4}, down);
    return r;
  }

  Light light_of(const Room& r, Settings::Visibility visibility) {
    Settings s = settings_;
    s.visibility = visibility;
    TriangleHost host(r.boxes);
    Hierarchical technique(s);
    return next_frame(technique, r.g, {.cut = true, .host = &host}).diffuse;
  }

  // Mean over the floor between two x, away from edges.
  static double floor_mean(const Room& r, const Light& light, double from_x, double to_x) {
    double sum = 0, count = 0;
    for (size_t i = 0; i < light.size(); ++i) {
      const glm::dmat4 world_from_view = glm::inverse(glm::dmat4(view_matrix(r.g)));
      const glm::dvec3 p(world_from_view * glm::dvec4(r.g.position_view[i], 1));
      if (r.g.depth[i] == 0 || std::abs(p.y) > 1e-3 || std::abs(p.z) > 1.5) continue;
      if (p.x < from_x || p.x > to_x) continue;
      sum += light[i].x;
      ++count;
    }
    EXPECT_GT(count, 100);
    return sum / count;
  }
  static glm::mat4 view_matrix(const CpuGBuffer& g) {
    glm::mat4 m;
    for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = g.view.view_from_world[static_cast<size_t>(i)];
    return m;
  }

  Settings settings_;
};

TEST_F(VisibilityTest, AClosedWallLetsNothingThrough) {
  const Room r = room(true);
  const double open = floor_mean(r, light_of(r, Settings::Visibility::none), 0.6, 2.6);
  EXPECT_GT(open, 1e-3);
  for (const auto voxelizer : {Settings::Voxelizer::compute, Settings::Voxelizer::raster}) {
    settings_.voxelizer = voxelizer;
    EXPECT_LT(floor_mean(r, light_of(r, Settings::Visibility::first_bounce), 0.6, 2.6),
              0.02 * open);
  }
}

TEST_F(VisibilityTest, NothingIsBlockedWhereNothingStands) {
  for (const bool with_wall : {false, true}) {
    const Room r = room(with_wall);
    const double open = floor_mean(r, light_of(r, Settings::Visibility::none), -1.9, -0.6);
    const double tested =
        floor_mean(r, light_of(r, Settings::Visibility::first_bounce), -1.9, -0.6);
    EXPECT_NEAR(tested / open, 1.0, 0.03) << (with_wall ? "with" : "without") << " wall";
  }
}

// A flat, rough-free floor has no speckle of its own: pixel by pixel, little is lost.
TEST_F(VisibilityTest, AFloorDoesNotShadeItself) {
  const Room r = room(false);
  const Light open = light_of(r, Settings::Visibility::none);
  const Light tested = light_of(r, Settings::Visibility::first_bounce);
  int dark = 0, lit = 0;
  for (size_t i = 0; i < open.size(); ++i) {
    if (r.g.depth[i] == 0 || r.g.normal[i].y < 0.5f || open[i].x < 5e-3) continue;
    ++lit;
    if (tested[i].x < 0.8 * open[i].x) ++dark;
  }
  EXPECT_GT(lit, 1000);
  EXPECT_LT(dark, lit / 100);
}

TEST_F(VisibilityTest, WithoutTrianglesItFails) {
  const Room r = room(false);
  const auto result = system().run([&](VkCommandBuffer commands) {
    Frame frame = context().record(commands);
    Settings s;
    s.visibility = Settings::Visibility::all_bounces;
    Hierarchical(s).render(frame, {.view = r.g.view, .g_buffer = r.g.upload(recorder())});
    return frame.finish();
  });
  ASSERT_FALSE(result.ok());
  EXPECT_NE(result.error().message.find("visibility"), std::string::npos);
}

}  // namespace
}  // namespace lueur
