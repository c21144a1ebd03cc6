// SPDX-License-Identifier: MIT
// Both voxelizers against exact arithmetic, and the levels.
#include "voxels/voxel_grid.h"

#include "support/layout.h"
#include "voxels/params.h"
#include "voxels/shaders.h"
#include "voxels/voxel_fixture.h"

namespace lueur {
namespace {

constexpr Extent kExtent{97, 61};

std::vector<TestMesh> solids_and_a_shell() {
  const builtin::Tessellation cut{0.5f};
  return {mesh_of([](auto& b) {
            builtin::add_sphere(b, {-1.1f, 0.3f, -4.2f}, 0.93f, 24);
          }),
          mesh_of([&](auto& b) {
            builtin::add_box(b, {0.13f, -1.27f, -6.1f}, {1.71f, -0.21f, -3.03f}, cut);
          }),
          mesh_of([](auto& b) {
            builtin::add_closed_tube(
                b,
                [](float t) {
                  const float a = 2.0f * builtin::kPi * t;
                  return glm::vec3(0.9f + 0.7f * std::cos(a), 0.7f + 0.5f * std::sin(a),
                                   -3.6f + 0.6f * std::sin(a));
                },
                0.23f, 40, 12);
          }),
          // Within and behind the others.
          mesh_of([&](auto& b) {
            builtin::add_box(b, {-2.9f, -0.9f, -7.9f}, {0.6f, 0.57f, -5.07f}, cut);
          }),
          shell_of({-2.3f, -1.41f, -3.11f}, {1.63f, 0.2f, -3.5f}, {0.1f, 0.87f, -0.3f})};
}

// A board between the others, that is solid in 256 and 512 slices and a shell in fewer.
std::vector<TestMesh> with_a_thin_board() {
  std::vector<TestMesh> meshes = solids_and_a_shell();
  meshes.push_back(mesh_of([](auto& b) {
    b.set_transform(glm::rotate(glm::mat4(1.0f), 0.4f, {0.2f, 1.0f, 0.1f}));
    builtin::add_box(b, {-1.6f, -1.1f, -4.43f}, {0.9f, 0.95f, -4.4f}, {0.5f});
  }));
  meshes.back().thickness = 0.03f;
  return meshes;
}

struct Differences {
  uint32_t columns = 0;
  uint64_t voxels = 0;
  uint32_t unexplained = 0;  // columns whose difference has no rounding beside it
};

// `edge_px`: how far from where it is a voxelizer may see an edge.
Differences compare(const Columns& found, const ExactVoxels& exact, double edge_px) {
  // Depths are off by some 1e-6 of themselves, which are up to 30 000 slices here.
  constexpr double kBorderSlices = 0.02;
  Differences differences;
  for (uint32_t y = 0; y < found.extent.height; ++y)
    for (uint32_t x = 0; x < found.extent.width; ++x) {
      if (found.same_column(exact.columns, x, y)) continue;
      ++differences.columns;
      for (uint32_t s = 0; s < found.slices; ++s)
        differences.voxels += found.at(x, y, s) != exact.columns.at(x, y, s);
      const size_t pixel = size_t{y} * found.extent.width + x;
      if (exact.edge_px[pixel] > edge_px && exact.border_slices[pixel] > kBorderSlices) {
        ++differences.unexplained;
        ADD_FAILURE() << "pixel " << x << ", " << y << ": edge " << exact.edge_px[pixel]
                      << " px away, border " << exact.border_slices[pixel] << " slices";
      }
    }
  return differences;
}

class VoxelGridTest : public VoxelTest,
                      public testing::WithParamInterface<std::tuple<Voxelizer, uint32_t>> {
 protected:
  void SetUp() override {
    VoxelTest::SetUp();
    if (voxelizer() == Voxelizer::raster && !recorder().has_logic_op())
      GTEST_SKIP() << "the device has no logicOp";
  }
  Voxelizer voxelizer() const { return std::get<0>(GetParam()); }
  uint32_t slices() const { return std::get<1>(GetParam()); }
};

TEST_P(VoxelGridTest, IsWhatExactArithmeticGives) {
  const std::vector<TestMesh> meshes = with_a_thin_board();
  const ExactVoxels exact = exact_voxels(meshes, kExtent, slices());
  const Columns found = voxels(meshes, kExtent, exact.nearest_z, slices(), voxelizer())[0];
  // Devices place vertices on a grid of 1/256 pixel, ours do not.
  const Differences d = compare(found, exact, voxelizer() == Voxelizer::raster ? 0.01 : 1e-3);
  EXPECT_EQ(d.unexplained, 0u);
  const double voxel_count = double{kExtent.width} * kExtent.height * slices();
  EXPECT_LT(static_cast<double>(d.voxels), 1e-3 * voxel_count);
}

// Slices are spent on the depths that are seen, however far away those are.
TEST_P(VoxelGridTest, WhatIsFarAwayHasFineSlicesToo) {
  const std::vector<TestMesh> meshes = {
      mesh_of([](auto& b) {
        builtin::add_box(b, {-900, -900, -831}, {900, 900, -830}, {1000.0f});
      }),
      mesh_of([](auto& b) {
        builtin::add_box(b, {-90, -90, -810}, {90, 90, -800}, {1000.0f});
      })};
  const ExactVoxels exact = exact_voxels(meshes, kExtent, slices());
  const Columns found = voxels(meshes, kExtent, exact.nearest_z, slices(), voxelizer())[0];
  uint32_t solid = 0;
  for (uint32_t s = 0; s < slices(); ++s)
    solid += found.at(kExtent.width / 2, kExtent.height / 2, s);
  // 10 of 30 m, and little more.
  EXPECT_NEAR(solid, slices() * 10 / 32.0, 1.0 + slices() * 1 / 32.0);
}

// Between nothing and a wall there is a board that is far thinner than a slice: wherever it is in
// front, it is in the grid. As a solid, its two faces would cancel in most columns.
TEST_P(VoxelGridTest, NoSolidIsTooThinToBeThere) {
  const std::vector<TestMesh> meshes = {mesh_of([](auto& b) {
                                          builtin::add_box(b, {-9, -9, -9}, {9, 9, -8}, {100.0f});
                                        }),
                                        mesh_of([](auto& b) {
                                          builtin::add_box(b, {-1, -1, -3.003f}, {1, 1, -3}, {100});
                                        })};
  for (const bool is_told : {false, true}) {
    std::vector<TestMesh> told = meshes;
    if (is_told) told[1].thickness = 0.003f;
    const ExactVoxels exact = exact_voxels(told, kExtent, slices());
    const Columns found = voxels(told, kExtent, exact.nearest_z, slices(), voxelizer())[0];
    const auto slice = static_cast<uint32_t>(slice_place(exact.range, 3.0f));
    uint32_t seen = 0, there = 0;
    for (uint32_t y = 0; y < kExtent.height; ++y)
      for (uint32_t x = 0; x < kExtent.width; ++x) {
        if (exact.nearest_z[size_t{y} * kExtent.width + x] > 3.001f) continue;
        ++seen;
        there += found.at(x, y, slice) || found.at(x, y, slice + 1);
      }
    ASSERT_GT(seen, 100u);
    if (is_told)
      EXPECT_EQ(there, seen);
    else
      EXPECT_LT(there, seen / 2);
  }
}

// Walls that pass beside and behind the eye, of a room that the eye is in: air up to the wall, then
// matter. A solid behind the eye changes nothing.
TEST_P(VoxelGridTest, TrianglesThatCrossTheEyesPlaneCount) {
  const builtin::Tessellation uncut{100.0f};
  std::vector<TestMesh> meshes = {mesh_of([&](auto& b) {
    builtin::add_box(b, {-1.37f, -0.19f, -7.3f}, {1.91f, 1.1f, 2.9f}, uncut);
  })};
  const ExactVoxels room = exact_voxels(meshes, kExtent, slices());
  meshes.push_back(mesh_of([&](auto& b) {
    builtin::add_box(b, {-0.5f, -0.5f, 0.01f}, {0.5f, 0.5f, 1.0f}, uncut);
  }));
  const Columns found = voxels(meshes, kExtent, room.nearest_z, slices(), voxelizer())[0];
  EXPECT_EQ(compare(found, room, voxelizer() == Voxelizer::raster ? 0.01 : 1e-3).unexplained, 0u);
  for (uint32_t y = 0; y < kExtent.height; ++y)
    for (uint32_t x = 0; x < kExtent.width; ++x) {
      ASSERT_FALSE(found.at(x, y, 0) && room.border_slices[size_t{y} * kExtent.width + x] > 0.01 &&
                   room.nearest_z[size_t{y} * kExtent.width + x] >
                       room.range.z_near + 1.0f / room.range.slices_per_m);
      ASSERT_TRUE(found.at(x, y, slices() - 1)) << x << ", " << y;
    }
}

// Pixel centres exactly on edges and vertices: each edge is crossed once, and no column leaks.
TEST_P(VoxelGridTest, SolidsThatLieOnThePixelsCentresAreClosed) {
  const Extent extent{65, 65};
  const builtin::Tessellation cut{0.25f};
  const std::vector<TestMesh> meshes = {
      mesh_of([&](auto& b) {
        builtin::add_box(b, {-1, -1, -4}, {1, 1, -2}, cut);
      }),
      mesh_of([](auto& b) {
        b.set_transform(glm::mat4(1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, -6, 1));
        builtin::add_sphere(b, {0, 0, 0}, 1.0f, 32);
      })};
  // A wall behind all that ends in front of the last slice.
  const std::vector<float> nearest_z(size_t{extent.width} * extent.height, 9.0f);
  std::vector<float> with_near = nearest_z;
  with_near[0] = 1.9f;
  const Columns found = voxels(meshes, extent, with_near, slices(), voxelizer())[0];
  uint32_t solid_columns = 0;
  for (uint32_t y = 0; y < extent.height; ++y)
    for (uint32_t x = 0; x < extent.width; ++x) {
      ASSERT_FALSE(found.at(x, y, slices() - 1)) << x << ", " << y;
      uint32_t solid = 0;
      for (uint32_t s = 0; s < slices(); ++s) solid += found.at(x, y, s);
      solid_columns += solid > 0;
    }
  // The front face is 2 of 4 m wide. At its rim, rays leave the box in the slice they entered.
  EXPECT_GE(solid_columns, 29u * 29u);
  EXPECT_LE(solid_columns, 33u * 33u);
}

// Along a row, what a tilted shell fills in neighbouring columns touches.
TEST_P(VoxelGridTest, TiltedShellsHaveNoHoles) {
  const std::vector<TestMesh> meshes = {
      shell_of({-3.0f, -2.0f, -1.5f}, {6.0f, 0.3f, -9.0f}, {0.0f, 4.0f, 0.4f})};
  const ExactVoxels exact = exact_voxels(meshes, kExtent, slices());
  const Columns found = voxels(meshes, kExtent, exact.nearest_z, slices(), voxelizer())[0];
  uint32_t pairs = 0;
  for (uint32_t y = 0; y < kExtent.height; ++y)
    for (uint32_t x = 0; x + 1 < kExtent.width; ++x) {
      const auto ends = [&](uint32_t column) {
        int first = -1, last = -2;
        for (uint32_t s = 0; s < slices(); ++s)
          if (found.at(column, y, s)) {
            if (first < 0) first = static_cast<int>(s);
            last = static_cast<int>(s);
          }
        return ivec2(first, last);
      };
      const ivec2 left = ends(x), right = ends(x + 1);
      if (left.x < 0 || right.x < 0) continue;
      ++pairs;
      ASSERT_LE(right.x, left.y + 1) << x << ", " << y;
    }
  EXPECT_GT(pairs, 1000u);
}

TEST_P(VoxelGridTest, CoarserLevelsAreSolidWhereAllPixelsAre) {
  std::vector<TestMesh> meshes = solids_and_a_shell();
  // A wall up to the picture's odd edges.
  meshes.push_back(mesh_of([](auto& b) {
    builtin::add_box(b, {-20.0f, -20.0f, -10.0f}, {20.0f, 20.0f, -8.3f}, {100.0f});
  }));
  const ExactVoxels exact = exact_voxels(meshes, kExtent, slices());
  const std::vector<Columns> levels =
      voxels(meshes, kExtent, exact.nearest_z, slices(), voxelizer(), 8);
  ASSERT_EQ(levels.size(), 8u);
  EXPECT_EQ(levels.back().extent, (Extent{1, 1}));
  uint64_t solid = 0;
  for (size_t k = 1; k < levels.size(); ++k) {
    const Columns& fine = levels[k - 1];
    const Columns& coarse = levels[k];
    for (uint32_t y = 0; y < coarse.extent.height; ++y)
      for (uint32_t x = 0; x < coarse.extent.width; ++x)
        for (uint32_t s = 0; s < slices(); ++s) {
          bool all = true;
          for (const uint32_t fine_y : {2 * y, 2 * y + 1})
            for (const uint32_t fine_x : {2 * x, 2 * x + 1})
              if (fine_x < fine.extent.width && fine_y < fine.extent.height)
                all = all && fine.at(fine_x, fine_y, s);
          ASSERT_EQ(coarse.at(x, y, s), all) << k << ": " << x << ", " << y << ", " << s;
          solid += all;
        }
  }
  EXPECT_GT(solid, 100u);
}

TEST_P(VoxelGridTest, WithoutSurfaceOrTrianglesThereIsAir) {
  const std::vector<float> nothing(size_t{kExtent.width} * kExtent.height, 0.0f);
  const std::vector<TestMesh> far_away = {mesh_of([](auto& b) {
    builtin::add_sphere(b, {0, 0, -50}, 1.0f, 16);
  })};
  for (const auto& meshes : {std::vector<TestMesh>{}, far_away}) {
    const Columns found = voxels(meshes, kExtent, nothing, slices(), voxelizer())[0];
    EXPECT_EQ(found.words, std::vector<uint32_t>(found.words.size(), 0u));
  }
  VoxelGrid grid;
  run([&](Frame&) {
    grid = voxelize(recorder(), {.screen = test_screen(kExtent),
                                 .geometry = geometry(kExtent, nothing),
                                 .slices = slices(),
                                 .voxelizer = voxelizer()});
    show(grid);
  });
  const Columns found = columns(grid, 0);
  EXPECT_EQ(found.words, std::vector<uint32_t>(found.words.size(), 0u));
}

INSTANTIATE_TEST_SUITE_P(All, VoxelGridTest,
                         testing::Combine(testing::Values(Voxelizer::compute, Voxelizer::raster),
                                          testing::Values(32u, 64u, 128u, 256u, 512u)));

class VoxelLimitTest : public VoxelTest {};

TEST_F(VoxelLimitTest, GridsThatTheDeviceCannotHoldFailTheFrame) {
  const uint32_t limit = recorder().device().properties.limits.maxImageDimension2D;
  const Extent extent{1, limit / 16 + 1};
  const auto result = system().run([&](VkCommandBuffer commands) {
    Frame frame = context().record(commands);
    const std::vector<float> nothing(extent.height, 0.0f);
    voxelize(recorder(),
             {.screen = test_screen(extent), .geometry = geometry(extent, nothing), .slices = 512});
    return frame.finish();
  });
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().kind, ErrorKind::usage);
  EXPECT_NE(result.error().message.find("512 slices"), std::string::npos);
  EXPECT_NE(result.error().message.find("fewer slices"), std::string::npos);
}

TEST(VoxelLayout, StructuresLieAsTheShadersReadThem) {
  expect_layout(shaders::voxels_toggle_comp, "ranges", sizeof(RangeData),
                {LUEUR_MEMBER(RangeData, row_x), LUEUR_MEMBER(RangeData, row_y),
                 LUEUR_MEMBER(RangeData, row_z), LUEUR_MEMBER(RangeData, first_index),
                 LUEUR_MEMBER(RangeData, vertex_offset), LUEUR_MEMBER(RangeData, triangle_count),
                 LUEUR_MEMBER(RangeData, thickness_m)});
  expect_layout(shaders::voxels_toggle_comp, "chunks", sizeof(Chunk),
                {LUEUR_MEMBER(Chunk, range), LUEUR_MEMBER(Chunk, first_triangle)});
  expect_layout(shaders::voxels_range_comp, "range", sizeof(VoxelRange),
                {LUEUR_MEMBER(VoxelRange, z_near), LUEUR_MEMBER(VoxelRange, slices_per_m),
                 LUEUR_MEMBER(VoxelRange, slices)});
  expect_layout(shaders::voxels_range_comp, "push", sizeof(RangeParams),
                {LUEUR_MEMBER(RangeParams, parts), LUEUR_MEMBER(RangeParams, slices)});
  expect_layout(shaders::voxels_range_part_comp, "push", sizeof(RangePartParams),
                {LUEUR_MEMBER(RangePartParams, extent)});
  expect_layout(shaders::voxels_toggle_comp, "push", sizeof(ToggleParams),
                {LUEUR_MEMBER(ToggleParams, extent), LUEUR_MEMBER(ToggleParams, place),
                 LUEUR_MEMBER(ToggleParams, chunks)});
  expect_layout(shaders::voxels_fill_comp, "push", sizeof(FillParams),
                {LUEUR_MEMBER(FillParams, extent), LUEUR_MEMBER(FillParams, words)});
  expect_layout(shaders::voxels_level_comp, "push", sizeof(LevelParams),
                {LUEUR_MEMBER(LevelParams, fine_extent), LUEUR_MEMBER(LevelParams, extent),
                 LUEUR_MEMBER(LevelParams, words)});
  expect_layout(shaders::voxels_raster_vert, "params", sizeof(RasterParams),
                {LUEUR_MEMBER(RasterParams, extent), LUEUR_MEMBER(RasterParams, place)});
  expect_layout(shaders::voxels_raster_vert, "push", sizeof(RasterDraw),
                {LUEUR_MEMBER(RasterDraw, range), LUEUR_MEMBER(RasterDraw, is_shell)});
  expect_layout(shaders::voxels_raster_copy_comp, "push", sizeof(RasterCopyParams),
                {LUEUR_MEMBER(RasterCopyParams, extent), LUEUR_MEMBER(RasterCopyParams, words)});
}

}  // namespace
}  // namespace lueur
