// SPDX-License-Identifier: MIT
// Walks through voxels, against a dense walk in double precision, and on the device.
#include "voxels/march.h"

#include <random>

#include "voxels/test_shaders/params.h"
#include "voxels/test_shaders/shaders.h"
#include "voxels/voxel_fixture.h"

namespace lueur {
namespace {

constexpr Extent kMarchExtent{96, 64};
constexpr uint32_t kSlices = 128;
const MarchBias kBias{kMarchBiasPx, kMarchBiasSlices};

// march() of march.glsl.
float march(const VoxelRange& range, const Columns& voxels, const MarchLine& line, int max_steps) {
  const March m = march_between(line.from, line.to, max_steps, kBias);
  for (int step = 0; step < m.steps; ++step) {
    const ivec2 slices = march_slices(range, m, step);
    const ivec2 pixel = march_pixel(m, step);
    for (int s = slices.x; s <= slices.y; ++s)
      if (voxels.at(static_cast<uint32_t>(pixel.x), static_cast<uint32_t>(pixel.y),
                    static_cast<uint32_t>(s)))
        return 0.0f;
  }
  return 1.0f;
}

// A room with a ball and a pillar in it.
std::vector<TestMesh> furnished_room() {
  const builtin::Tessellation uncut{100.0f};
  return {mesh_of([&](auto& b) {
            builtin::add_box(b, {-2.37f, -1.23f, -7.3f}, {2.61f, 1.7f, 2.9f}, uncut);
          }),
          mesh_of([](auto& b) {
            builtin::add_sphere(b, {-0.9f, -0.4f, -4.2f}, 0.6f, 24);
          }),
          mesh_of([&](auto& b) {
            builtin::add_box(b, {0.6f, -1.2f, -5.1f}, {1.2f, 0.8f, -4.2f}, uncut);
          })};
}

// Lines between points that are seen.
std::vector<MarchLine> lines_between(const std::vector<float>& nearest_z, size_t count) {
  std::mt19937 random(5);
  const auto point = [&] {
    const auto x = static_cast<uint32_t>(random() % kMarchExtent.width);
    const auto y = static_cast<uint32_t>(random() % kMarchExtent.height);
    return vec3(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f,
                nearest_z[size_t{y} * kMarchExtent.width + x]);
  };
  std::vector<MarchLine> lines(count);
  for (MarchLine& line : lines) line = {point(), point()};
  return lines;
}

// A point in space that is seen at a pixel position.
glm::dvec3 in_space(const glm::dvec3& p) {
  const Screen screen = test_screen(kMarchExtent);
  const glm::dvec2 ray =
      glm::dvec2(p) * glm::dvec2(screen.ray_scale) + glm::dvec2(screen.ray_offset);
  return {ray * p.z, -p.z};
}

TEST(March, StepsLieOnTheLineInSpace) {
  const VoxelRange range{1.0f, 20.0f, kSlices};
  std::mt19937 random(3);
  std::uniform_real_distribution<float> x(0.0f, 96.0f), y(0.0f, 64.0f), z(1.2f, 7.0f);
  for (int i = 0; i < 1000; ++i) {
    const MarchLine line{vec3(x(random), y(random), z(random)),
                         vec3(x(random), y(random), z(random))};
    const March m = march_between(line.from, line.to, 16, kBias);
    const glm::dvec3 from = in_space(line.from), along = in_space(line.to) - from;
    for (int step = 0; step < m.steps; ++step) {
      // The middle of the step in space, and how far it is from the line.
      const glm::dvec2 at_px = glm::dvec2(m.middle_px) + double(step) * glm::dvec2(m.step_px);
      const double at_z = 1.0 / (double{m.inverse_z} + step * double{m.inverse_z_step});
      const glm::dvec3 at = in_space({at_px, at_z}) - from;
      const glm::dvec3 off = at - along * (glm::dot(at, along) / glm::dot(along, along));
      ASSERT_LT(glm::length(off), 1e-5 * glm::length(along) + 1e-5) << i << ", step " << step;
      const ivec2 slices = march_slices(range, m, step);
      const double place = (at_z - range.z_near) * range.slices_per_m - kBias.slices;
      ASSERT_LE(slices.x, std::max(place, 0.0) + 1e-3);
      ASSERT_GE(slices.y + 1, std::min(place, kSlices - 1.0) - 1e-3);
    }
  }
}

TEST(March, StepsTileWhatIsTested) {
  const MarchLine line{vec3(10.0f, 20.0f, 2.0f), vec3(40.0f, 60.0f, 3.0f)};  // 50 pixels
  for (const int max_steps : {1, 7, 1000}) {
    const March m = march_between(line.from, line.to, max_steps, kBias);
    EXPECT_EQ(m.steps, std::min(max_steps, 48));
    const float step_px = length(m.step_px);
    EXPECT_NEAR(step_px * static_cast<float>(m.steps), 47.0f, 1e-3f);
    EXPECT_NEAR(length(m.middle_px - vec2(10.0f, 20.0f)), 1.5f + 0.5f * step_px, 1e-4f);
  }
  // What is no farther apart than both ends' bias sees each other.
  EXPECT_EQ(march_between(line.from, line.from, 8, kBias).steps, 0);
  EXPECT_EQ(march_between(line.from, line.from + vec3(2.9f, 0.0f, 0.0f), 8, kBias).steps, 0);
  EXPECT_EQ(march_between(line.from, line.from + vec3(3.1f, 0.0f, 0.0f), 8, kBias).steps, 1);
}

// Wherever a line goes, also behind the eye, its end is on it and in the picture, and as far away
// as that allows.
TEST(March, LinesEndWhereTheyLeaveThePicture) {
  const Screen screen = test_screen(kMarchExtent);
  const vec2 extent_px(kMarchExtent.width, kMarchExtent.height);
  std::mt19937 random(4);
  std::uniform_real_distribution<float> x(1.0f, 95.0f), y(1.0f, 63.0f), z(1.2f, 7.0f),
      anywhere(-9.0f, 9.0f);
  int inside = 0, behind = 0;
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 from = in_space({x(random), y(random), z(random)});
    const glm::dvec3 to(anywhere(random), anywhere(random), anywhere(random));
    const vec3 end = march_end(screen, extent_px, vec3(from), vec3(to));
    const glm::dvec3 reached = in_space(end) - from;
    const double share = glm::dot(reached, to - from) / glm::dot(to - from, to - from);
    ASSERT_LT(glm::length(reached - share * (to - from)), 1e-3 * glm::length(to)) << i;
    ASSERT_GT(share, 0);
    const double off_px = std::min({end.x, end.y, extent_px.x - end.x, extent_px.y - end.y});
    ASSERT_GT(off_px, -1e-2) << i;
    ASSERT_GT(end.z, 0) << i;
    // It ends at `to`, at the picture's edge, or next to the eye.
    if (share > 1 - 1e-4)
      ++inside;
    else
      ASSERT_TRUE(off_px < 1e-2 || end.z < 1e-2) << i << ", " << off_px << ", " << end.z;
    behind += to.z > 0;
  }
  EXPECT_GT(inside, 100);
  EXPECT_GT(behind, 100);
}

// With a step a pixel, walks meet what a dense walk meets for more than a pixel, and nothing that
// is farther than half a pixel from it.
TEST(March, MeetsWhatADenseWalkMeets) {
  constexpr int kDensity = 32;  // samples a pixel
  const ExactVoxels exact = exact_voxels(furnished_room(), kMarchExtent, kSlices);
  uint32_t blocked = 0, free = 0;
  for (const MarchLine& line : lines_between(exact.nearest_z, 4000)) {
    const double length_px = glm::length(glm::dvec2(line.to) - glm::dvec2(line.from));
    const auto solid_at = [&](double at_px, double depth_px) {
      const double t = at_px / length_px;
      const glm::dvec2 p = glm::mix(glm::dvec2(line.from), glm::dvec2(line.to), t);
      const double u = depth_px / length_px;
      const double z = 1.0 / glm::mix(1.0 / line.from.z, 1.0 / line.to.z, u);
      const double place = (z - exact.range.z_near) * exact.range.slices_per_m - kBias.slices;
      return place >= 0 && place < kSlices &&
             exact.columns.at(static_cast<uint32_t>(p.x), static_cast<uint32_t>(p.y),
                              static_cast<uint32_t>(place));
    };
    int run = 0, longest = 0;
    bool near_any = false;
    for (int i = 0; i < int((length_px - 2 * kBias.px) * kDensity); ++i) {
      const double at_px = kBias.px + (i + 0.5) / kDensity;
      run = solid_at(at_px, at_px) ? run + 1 : 0;
      longest = std::max(longest, run);
      for (double off = -0.5; off <= 0.5; off += 1.0 / kDensity)
        near_any = near_any || solid_at(at_px, at_px + off);
    }
    const float found = march(exact.range, exact.columns, line, 1000);
    if (longest > kDensity + 1) {
      ++blocked;
      ASSERT_EQ(found, 0.0f) << longest;
    }
    if (!near_any) {
      ++free;
      ASSERT_EQ(found, 1.0f);
    }
  }
  EXPECT_GT(blocked, 300u);
  EXPECT_GT(free, 300u);
}

// A wall parallel to the screen is one slice everywhere.
TEST(March, AFlatWallNeverShadowsItself) {
  for (const float wall_z : {3.0f, 3.2f, 3.9999f, 4.0f, 4.0001f, 5.7f}) {
    const ExactVoxels exact = exact_voxels(
        {mesh_of([&](auto& b) {
           builtin::add_box(b, {-9.0f, -9.0f, -9.0f}, {9.0f, 9.0f, -wall_z}, {100.0f});
         }),
         // Something near, which makes the grid begin before the wall.
         mesh_of([&](auto& b) {
           builtin::add_box(b, {-0.03f, -0.03f, -2.1f}, {0.03f, 0.03f, -2.0f}, {100.0f});
         })},
        kMarchExtent, kSlices);
    for (MarchLine line : lines_between(exact.nearest_z, 1000)) {
      // Only above what is near.
      line.from.y = std::min(line.from.y, 20.5f);
      line.to.y = std::min(line.to.y, 20.5f);
      line.from.z = line.to.z = wall_z;
      ASSERT_EQ(march(exact.range, exact.columns, line, 1000), 1.0f) << wall_z;
    }
  }
}

class MarchOnDeviceTest : public VoxelTest {};

TEST_F(MarchOnDeviceTest, IsWhatTheCpuFinds) {
  constexpr int kMaxSteps = 12;
  const std::vector<TestMesh> meshes = furnished_room();
  const ExactVoxels exact = exact_voxels(meshes, kMarchExtent, kSlices);
  const std::vector<MarchLine> lines = lines_between(exact.nearest_z, 2048);
  const auto count = static_cast<uint32_t>(lines.size());
  run([&](Frame&) {
    const TriangleBatch batch = upload(meshes);
    const VoxelGrid grid =
        voxelize(recorder(), {.triangles = {&batch, 1},
                              .screen = test_screen(kMarchExtent),
                              .geometry = geometry(kMarchExtent, exact.nearest_z),
                              .slices = kSlices});
    const Image visibility = recorder().image("visibility", {count, 1}, Format::r32f);
    recorder().dispatch("test.march", {.shader = shaders::voxels_test_shaders_march_comp,
                                       .params = MarchParams{int(count), kMaxSteps, kBias},
                                       .read = {{"voxels", grid.levels[0]},
                                                {"range", grid.range},
                                                {"lines", recorder().upload(lines)}},
                                       .write = {{"visibility", visibility}},
                                       .over = {count, 1}});
    recorder().read_back("visibility", visibility);
  });
  const Pixels visibility = pixels("visibility");
  uint32_t differing = 0, blocked = 0;
  for (uint32_t i = 0; i < count; ++i) {
    const float expected = march(exact.range, exact.columns, lines[i], kMaxSteps);
    differing += visibility.samples[i] != expected;
    blocked += expected == 0.0f;
  }
  // Rounding moves a step over the border of a voxel now and then.
  EXPECT_LE(differing, count / 200);
  EXPECT_GT(blocked, count / 10);
  EXPECT_LT(blocked, count * 9 / 10);
}

}  // namespace
}  // namespace lueur
