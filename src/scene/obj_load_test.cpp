// SPDX-License-Identifier: MIT
// Geometry of OBJ files: what stands in the file is what comes out.
#include "scene/obj_test_files.h"
#include "scene/scene_file.h"

namespace lueur {
namespace {

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

// Two squares that share the edge x = 1; the second leans by 45 degrees.
const std::string kRoof = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 -1\nv 2 1 -1\n";

TEST_F(ObjTest, SquareOfNegativeIndicesBecomesTwoTriangles) {
  const Scene scene = loaded(kSquare + "f -4 -3 -2 -1\n");
  ASSERT_EQ(scene.meshes.size(), 1u);
  EXPECT_EQ(scene.meshes[0].vertices.size(), 4u);
  EXPECT_EQ(triangle_count(scene), 2u);
  EXPECT_EQ(scene.meshes[0].name, "file");
  for (const Vertex& vertex : scene.meshes[0].vertices)
    EXPECT_EQ(vertex.normal, glm::vec3(0, 0, 1));
  EXPECT_TRUE(scene.warnings.empty()) << scene.warnings[0];
}

TEST_F(ObjTest, LinesMayGoOnAndNumbersMayHaveSigns) {
  const Scene scene = loaded(
      "\xEF\xBB\xBF# comment that ends in a backslash \\\nv +0 0 0 # here too\r\nv 1 0 \\\n0\n"
      "v 0 1e0 0\nf 1 \\\r\n 2\\\n 3\n");
  EXPECT_EQ(triangle_count(scene), 1u);
}

TEST_F(ObjTest, TextureCoordinatesHaveTheirOriginAtTheTop) {
  const Scene scene = loaded(kSquare + "vt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\n");
  const Mesh& mesh = scene.meshes[0];
  for (const Vertex& vertex : mesh.vertices) {
    EXPECT_EQ(vertex.uv, glm::vec2(vertex.position.x, 1.0f - vertex.position.y));
    EXPECT_EQ(vertex.tangent, glm::vec4(1, 0, 0, 1));  // u grows along x, v up along y
  }
}

TEST_F(ObjTest, GivenNormalsAreKeptAndMadeUnit) {
  const Scene scene = loaded(kSquare + "vn 0 3 4\ns 1\nf 1//1 2//1 3//-1\n");
  for (const Vertex& vertex : scene.meshes[0].vertices) {
    EXPECT_NEAR(vertex.normal.y, 0.6f, 1e-6f);
    EXPECT_NEAR(vertex.normal.z, 0.8f, 1e-6f);
  }
}

TEST_F(ObjTest, SmoothingGroupsShareNormalsWithinThemOnly) {
  const auto shared_edge_normals = [](const Scene& scene) {
    std::vector<glm::vec3> normals;
    for (const Vertex& vertex : scene.meshes[0].vertices)
      if (vertex.position == glm::vec3(1, 0, 0)) normals.push_back(vertex.normal);
    return normals;
  };
  EXPECT_EQ(shared_edge_normals(loaded(kRoof + "f 1 2 3 4\nf 2 5 6 3\n")).size(), 2u);
  EXPECT_EQ(shared_edge_normals(loaded(kRoof + "s 1\nf 1 2 3 4\ns 2\nf 2 5 6 3\n")).size(), 2u);
  EXPECT_EQ(shared_edge_normals(loaded(kRoof + "s 1\nf 1 2 3 4\ns off\nf 2 5 6 3\n")).size(), 2u);
  const auto smooth = shared_edge_normals(loaded(kRoof + "s 1\nf 1 2 3 4\nf 2 5 6 3\n"));
  ASSERT_EQ(smooth.size(), 1u);
  // Areas 1 and sqrt(2), normals (0 0 1) and (1 0 1)/sqrt(2): the sum is (1 0 2).
  EXPECT_NEAR(smooth[0].x / smooth[0].z, 0.5f, 1e-6f);
}

TEST_F(ObjTest, ObjectsAndGroupsAreMeshesByName) {
  const Scene scene =
      loaded(kSquare + "o box\nf 1 2 3\ng lid\nf 1 3 4\no ball\nf 1 2 4\no box\nf 2 3 4\n");
  ASSERT_EQ(scene.meshes.size(), 3u);
  EXPECT_EQ(scene.meshes[0].name, "box");
  EXPECT_EQ(scene.meshes[0].indices.size(), 6u);
  EXPECT_EQ(scene.meshes[1].name, "box/lid");
  EXPECT_EQ(scene.meshes[2].name, "ball");
  EXPECT_EQ(scene.nodes[1].name, "box/lid");
  EXPECT_EQ(scene.instances.size(), 3u);
}

TEST_F(ObjTest, OneMeshHasOnePrimitiveForEachMaterial) {
  write("file.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
  const Scene scene = loaded("mtllib file.mtl\n" + kSquare +
                             "usemtl red\nf 1 2 3\nusemtl blue\nf 1 3 4\nusemtl red\nf 2 3 4\n");
  ASSERT_EQ(scene.meshes[0].primitives.size(), 2u);
  EXPECT_EQ(scene.meshes[0].primitives[0].index_count, 6u);
  EXPECT_EQ(scene.materials[static_cast<size_t>(scene.meshes[0].primitives[1].material)].name,
            "blue");
}

TEST_F(ObjTest, WhatIsNoPolygonIsLeftOutWithAWarning) {
  const Scene scene = loaded(kSquare + "p 1\nl 1 2\ncstype bezier\nf 1 2\nfoo 3\n");
  EXPECT_TRUE(scene.instances.empty());
  for (const char* what : {"points and lines", "free-form", "three corners", "'foo'", "nothing"})
    EXPECT_TRUE(warns_of(scene, what)) << what;
}

TEST_F(ObjTest, SceneFilesAreToldApart) {
  write("file.obj", kSquare + "f 1 2 3\n");
  std::filesystem::copy(folder_ / "asset/file.obj", folder_ / "asset/other.txt");
  EXPECT_TRUE(load_scene_file(folder_ / "asset/file.obj").ok());
  EXPECT_TRUE(load_scene_file(folder_ / "asset/other.txt").ok());
  write("file.obj", R"({"asset":{"version":"2.0"}})");
  EXPECT_TRUE(load_scene_file(folder_ / "asset/file.obj").ok());
  EXPECT_FALSE(load_scene_file(folder_ / "asset/missing.obj").ok());
  EXPECT_FALSE(load_scene_file(folder_ / "asset").ok());
  EXPECT_TRUE(has_scene_ending("A.OBJ"));
  EXPECT_FALSE(has_scene_ending("obj"));
}

}  // namespace
}  // namespace lueur
