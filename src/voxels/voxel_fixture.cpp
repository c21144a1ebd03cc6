// SPDX-License-Identifier: MIT
#include "voxels/voxel_fixture.h"

#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "voxels/params.h"
#include "voxels/test_shaders/shaders.h"

namespace lueur {
namespace {

// A triangle in homogeneous pixel coordinates, see triangle.glsl.
struct Seen {
  glm::dvec3 corner[3];
};

// Distance of p from the segment.
double distance_px(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 along = b - a;
  const double length2 = glm::dot(along, along);
  const double t = length2 > 0 ? std::clamp(glm::dot(p - a, along) / length2, 0.0, 1.0) : 0.0;
  return glm::length(p - a - along * t);
}

// 1 / z of the triangle's plane as a function a + b x + c y of the pixel position.
glm::dvec3 inverse_z_plane(const Seen& t) {
  const glm::dvec3 n = glm::cross(t.corner[1] - t.corner[0], t.corner[2] - t.corner[0]);
  const double d = glm::dot(n, t.corner[0]);
  return glm::dvec3(n.z, n.x, n.y) / d;
}

// True if the pixel position is inside, for triangles in front of the eye and behind it alike.
bool covers(const Seen& t, const glm::dvec3& pixel) {
  const double s = glm::dot(t.corner[0], glm::cross(t.corner[1], t.corner[2])) < 0 ? -1.0 : 1.0;
  for (int i = 0; i < 3; ++i)
    if (s * glm::dot(pixel, glm::cross(t.corner[i], t.corner[(i + 1) % 3])) < 0) return false;
  return true;
}

}  // namespace

TestMesh mesh_of(const std::function<void(builtin::MeshBuilder&)>& add) {
  builtin::MeshBuilder builder;
  add(builder);
  const Mesh built = builder.finish("mesh");
  TestMesh mesh;
  for (const Vertex& vertex : built.vertices) mesh.positions.push_back(vertex.position);
  mesh.indices = built.indices;
  return mesh;
}

TestMesh shell_of(const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v) {
  return {{corner, corner + u, corner + u + v, corner + v}, {0, 1, 2, 0, 2, 3}, false};
}

Screen test_screen(Extent extent) {
  const float tan_v = static_cast<float>(extent.height) / static_cast<float>(extent.width);
  Screen screen{};
  screen.ray_scale = vec2(2.0f / static_cast<float>(extent.width),
                          -2.0f * tan_v / static_cast<float>(extent.height));
  screen.ray_offset = vec2(-1.0f, tan_v);
  return screen;
}

ExactVoxels exact_voxels(const std::vector<TestMesh>& meshes, Extent extent, uint32_t slices) {
  const Screen screen = test_screen(extent);
  std::vector<std::pair<Seen, double>> triangles;  // with what they bound, m
  for (const TestMesh& mesh : meshes)
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
      Seen seen;
      for (size_t k = 0; k < 3; ++k) {
        const glm::dvec3 p = mesh.positions[mesh.indices[i + k]];
        seen.corner[k] = {(p.x + p.z * screen.ray_offset.x) / screen.ray_scale.x,
                          (p.y + p.z * screen.ray_offset.y) / screen.ray_scale.y, -p.z};
      }
      const double told = mesh.thickness > 0 ? double{mesh.thickness} : 1e9;
      triangles.emplace_back(seen, mesh.closed ? told : 0.0);
    }

  const size_t pixels = size_t{extent.width} * extent.height;
  ExactVoxels exact;
  exact.columns = {extent, slices, std::vector<uint32_t>(pixels * (slices / 32))};
  exact.nearest_z.assign(pixels, 0.0f);
  exact.edge_px.assign(pixels, 1e9);
  exact.border_slices.assign(pixels, 1e9);
  struct Hit {
    size_t pixel;
    double z;              // at the pixel's centre
    double near_z, far_z;  // within the pixel
    double thickness_m;
  };
  std::vector<Hit> hits;
  double least = 1e9, greatest = 0;
  for (const auto& [t, thickness_m] : triangles) {
    const glm::dvec3 plane = inverse_z_plane(t);
    const glm::dvec3 z(t.corner[0].z, t.corner[1].z, t.corner[2].z);
    const double z_min = std::max(1e-3, std::min({z.x, z.y, z.z}));
    const double z_max = std::max({z.x, z.y, z.z});
    for (size_t i = 0; i < pixels; ++i) {
      const glm::dvec2 p(static_cast<double>(i % extent.width) + 0.5,
                         static_cast<double>(i / extent.width) + 0.5);
      if (std::min({z.x, z.y, z.z}) > 0)
        for (int k = 0; k < 3; ++k) {
          const glm::dvec3 a = t.corner[k], b = t.corner[(k + 1) % 3];
          exact.edge_px[i] =
              std::min(exact.edge_px[i], distance_px(p, glm::dvec2(a) / a.z, glm::dvec2(b) / b.z));
        }
      if (!covers(t, glm::dvec3(p, 1.0))) continue;
      const double inverse_z = plane[0] + plane[1] * p.x + plane[2] * p.y;
      if (inverse_z <= 0) continue;
      const double half = 0.5 * (std::abs(plane[1]) + std::abs(plane[2]));
      const auto bounded = [&](double at) {
        return 1.0 / std::clamp(at, 1.0 / z_max, 1.0 / z_min);
      };
      hits.push_back({i, bounded(inverse_z), bounded(inverse_z + half), bounded(inverse_z - half),
                      thickness_m});
      const double seen_z = 1.0 / inverse_z;
      float& nearest = exact.nearest_z[i];
      if (nearest == 0.0f || seen_z < nearest) nearest = static_cast<float>(seen_z);
    }
  }
  for (const float z : exact.nearest_z)
    if (z > 0) {
      least = std::min(least, double{z});
      greatest = std::max(greatest, double{z});
    }
  const double unit = std::exp2(std::floor(std::log2(greatest - least))) / kRangeParts;
  const double z_near = std::max(std::exp2(std::floor(4.0 * std::log2(least)) / 4.0),
                                 std::floor(least / unit) * unit);
  const double z_far = (std::floor(greatest / unit) + 1.0) * unit;
  exact.range = {static_cast<float>(z_near), static_cast<float>(slices / (z_far - z_near)), slices};

  // Solids first, then shells over them.
  const int count = static_cast<int>(slices);
  for (const bool solid : {true, false})
    for (const Hit& hit : hits) {
      const bool closed = hit.thickness_m > 0;
      if (!(solid ? closed : hit.thickness_m * exact.range.slices_per_m < 1.0)) continue;
      const auto place_of = [&](double z) { return (z - z_near) * exact.range.slices_per_m; };
      const double first = place_of(closed ? hit.z : hit.near_z);
      const double last = place_of(closed ? hit.z : hit.far_z);
      for (const double place : {first, last})
        exact.border_slices[hit.pixel] =
            std::min(exact.border_slices[hit.pixel], std::abs(place - std::round(place)));
      const int low = std::max(static_cast<int>(std::floor(first)), 0);
      const int high = solid ? count - 1 : std::min(static_cast<int>(std::floor(last)), count - 1);
      for (int s = low; s <= high; ++s) {
        uint32_t& word = exact.columns.words[hit.pixel * (slices / 32) + s / 32];
        word = solid ? word ^ 1u << (s % 32) : word | 1u << (s % 32);
      }
    }
  return exact;
}

TriangleBatch VoxelTest::upload(const std::vector<TestMesh>& meshes) {
  // As an engine has it: other floats around the positions, all meshes in the same buffers.
  constexpr uint32_t kStride = 5, kFirst = 1;
  std::vector<float> floats;
  std::vector<uint32_t> indices;
  TriangleBatch batch{.first_float = kFirst, .stride_floats = kStride, .ranges = {}};
  for (const TestMesh& mesh : meshes) {
    TriangleRange range{.first_index = static_cast<uint32_t>(indices.size()),
                        .index_count = static_cast<uint32_t>(mesh.indices.size()),
                        .vertex_offset = static_cast<int32_t>(floats.size() / kStride),
                        .closed = mesh.closed,
                        .thickness = 0.5f * mesh.thickness};
    // Half the size, twice as large in the world.
    const glm::mat4 twice(glm::mat3(2.0f));
    std::copy_n(glm::value_ptr(twice), 16, range.world_from_object.begin());
    for (const glm::vec3& p : mesh.positions)
      floats.insert(floats.end(), {99.0f, 0.5f * p.x, 0.5f * p.y, 0.5f * p.z, 99.0f});
    indices.insert(indices.end(), mesh.indices.begin(), mesh.indices.end());
    batch.ranges.push_back(range);
  }
  batch.vertices = recorder().upload(floats);
  batch.indices = recorder().upload(indices);
  return batch;
}

Image VoxelTest::geometry(Extent extent, const std::vector<float>& nearest_z) {
  std::vector<glm::vec4> pixels;
  for (const float z : nearest_z) pixels.emplace_back(0.0f, 0.0f, 1.0f, z);
  return recorder().upload_image("geometry", extent, Format::rgba32f, pixels.data());
}

void VoxelTest::show(const VoxelGrid& grid) {
  for (size_t k = 0; k < grid.levels.size(); ++k) {
    const Image bytes = recorder().image("bytes", grid.levels[k].extent, Format::rgba32f);
    recorder().dispatch("test.bytes", {.shader = shaders::voxels_test_shaders_bytes_comp,
                                       .read = {{"words", grid.levels[k]}},
                                       .write = {{"bytes", bytes}},
                                       .over = bytes.extent});
    recorder().read_back("level" + std::to_string(k), bytes);
  }
}

Columns VoxelTest::columns(const VoxelGrid& grid, uint32_t level) {
  const Pixels bytes = pixels("level" + std::to_string(level));
  const Extent extent = grid.extents[level];
  Columns columns{extent, grid.slices,
                  std::vector<uint32_t>(size_t{extent.width} * extent.height * grid.slices / 32)};
  for (uint32_t row = 0; row < bytes.extent.height; ++row)
    for (uint32_t x = 0; x < extent.width; ++x) {
      uint32_t word = 0;
      for (uint32_t b = 4; b-- > 0;)
        word = word << 8 |
               static_cast<uint32_t>(bytes.samples[(size_t{row} * extent.width + x) * 4 + b]);
      const uint32_t words = columns.words_a_column();
      columns.word(x, row / words, row % words) = word;
    }
  return columns;
}

std::vector<Columns> VoxelTest::voxels(const std::vector<TestMesh>& meshes, Extent extent,
                                       const std::vector<float>& nearest_z, uint32_t slices,
                                       Voxelizer voxelizer, uint32_t levels) {
  VoxelGrid grid;
  run([&](Frame&) {
    const TriangleBatch batch = upload(meshes);
    grid = voxelize(recorder(), {.triangles = {&batch, 1},
                                 .screen = test_screen(extent),
                                 .geometry = geometry(extent, nearest_z),
                                 .slices = slices,
                                 .levels = levels,
                                 .voxelizer = voxelizer});
    show(grid);
  });
  std::vector<Columns> all;
  for (uint32_t k = 0; k < grid.levels.size(); ++k) all.push_back(columns(grid, k));
  return all;
}

}  // namespace lueur
