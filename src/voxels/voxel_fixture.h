// SPDX-License-Identifier: MIT
// Solids and shells in front of a camera, their voxels from the device, and what these should be.
#pragma once

#include <vector>

#include "scene/builtin/shapes.h"
#include "support/gpu_test.h"
#include "voxels/slices.h"
#include "voxels/voxel_grid.h"

namespace lueur {

// Triangles in world space.
struct TestMesh {
  std::vector<glm::vec3> positions;
  std::vector<uint32_t> indices;
  bool closed = true;
  float thickness = 0.0f;  // m, 0: not told
};

TestMesh mesh_of(const std::function<void(builtin::MeshBuilder&)>& add);
TestMesh shell_of(const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v);

// The camera at the origin looks along -z, 90 degrees wide.
Screen test_screen(Extent extent);

// Bits of all voxels.
struct Columns {
  Extent extent;
  uint32_t slices = 0;
  std::vector<uint32_t> words;  // of each pixel, rows from the top

  uint32_t words_a_column() const { return slices / 32; }
  uint32_t& word(uint32_t x, uint32_t y, uint32_t w) {
    return words[(size_t{y} * extent.width + x) * words_a_column() + w];
  }
  bool at(uint32_t x, uint32_t y, uint32_t slice) const {
    const size_t pixel = size_t{y} * extent.width + x;
    return words[pixel * words_a_column() + slice / 32] >> (slice % 32) & 1;
  }
  bool same_column(const Columns& other, uint32_t x, uint32_t y) const {
    const size_t first = (size_t{y} * extent.width + x) * words_a_column();
    return std::equal(&words[first], &words[first] + words_a_column(), &other.words[first]);
  }
};

// What exact arithmetic gives: rays through pixel centres against all triangles, in double
// precision.
struct ExactVoxels {
  VoxelRange range;
  std::vector<float> nearest_z;  // of each pixel, 0: nothing
  Columns columns;
  // Of each pixel, how far the column is from being another one: the least distance of the pixel's
  // centre from an edge, and of a crossing from the border of a slice.
  std::vector<double> edge_px;
  std::vector<double> border_slices;
};
ExactVoxels exact_voxels(const std::vector<TestMesh>& meshes, Extent extent, uint32_t slices);

class VoxelTest : public GpuTest {
 protected:
  TriangleBatch upload(const std::vector<TestMesh>& meshes);
  // The whole of level 0 to `levels` - 1 for these meshes; `nearest_z` goes into the geometry.
  std::vector<Columns> voxels(const std::vector<TestMesh>& meshes, Extent extent,
                              const std::vector<float>& nearest_z, uint32_t slices,
                              Voxelizer voxelizer, uint32_t levels = 1);
  Image geometry(Extent extent, const std::vector<float>& nearest_z);
  // Makes the bits of a grid readable; call columns() once the frame is done.
  void show(const VoxelGrid& grid);
  Columns columns(const VoxelGrid& grid, uint32_t level);
};

}  // namespace lueur
