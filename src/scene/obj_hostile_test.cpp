// SPDX-License-Identifier: MIT
// OBJ and MTL files that are damaged or made to harm: refused in one line that names the place.
#include "scene/obj_test_files.h"

namespace lueur {
namespace {
namespace fs = std::filesystem;

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST_F(ObjTest, IndicesThatPointAtNothingAreRefused) {
  expect_refused(kTriangle + "f 1 2 4\n", {"file.obj: line 4", "index 4", "3 positions"});
  expect_refused(kTriangle + "f 1 2 -4\n", {"line 4", "index -4"});
  expect_refused(kTriangle + "f 0 1 2\n", {"line 4", "index 0"});
  expect_refused("f -1 -2 -3\n" + kTriangle, {"line 1", "index -1", "0 positions"});
  expect_refused(kTriangle + "f 1/1 2/1 3/1\n", {"line 4", "0 texture coordinates"});
  expect_refused(kTriangle + "f 1//1 2//1 3//1\n", {"line 4", "0 normals"});
  expect_refused(kTriangle + "f 1 2 9223372036854775807\n", {"line 4", "9223372036854775807"});
  expect_refused(kTriangle + "f 1 2 -9223372036854775808\n", {"line 4", "-9223372036854775808"});
  expect_refused(kTriangle + "f 1 2 99999999999999999999\n", {"line 4", "is not an index"});
  expect_refused(kTriangle + "f 1 2 3.0\n", {"line 4", "'3.0' is not an index"});
  expect_refused(kTriangle + "f 1 2 /3\n", {"line 4", "'' is not an index"});
  expect_refused(kTriangle + "f 1 2 3/1/1/1\n", {"line 4"});
}

TEST_F(ObjTest, NumbersThatAreNoneAreRefused) {
  for (const char* number : {"nan", "inf", "-inf", "1e39", "1e999", "0x10", "1,5", "1.0f", "--1"})
    expect_refused("# first\nv 0 0 " + std::string(number) + "\n",
                   {"file.obj: line 2", number, "not a finite number"});
  expect_refused("v 0 0\n", {"line 1", "needs 3 numbers"});
  expect_refused("vt\n", {"line 1", "needs 1 numbers"});
  expect_refused("s five\n", {"line 1", "smoothing group"});
  EXPECT_TRUE(load(kTriangle + "v 1e-999 1e-60 -0\nf 1 2 4\n").ok());
}

TEST_F(ObjTest, LimitsHoldBeforeMemoryIsTaken) {
  LoadLimits limits;
  limits.vertices = 2;
  expect_refused(kTriangle, {"line 3", "more than 2 positions"}, limits);
  limits = {};
  limits.indices = 5;
  expect_refused(kTriangle + "f 1 2 3\nf 1 2 3\n", {"line 5", "more than 5"}, limits);
  limits = {};
  limits.polygon_corners = 3;
  expect_refused(kTriangle + "f 1 2 3 1\n", {"line 4", "more than 3 corners"}, limits);
  limits = {};
  limits.nodes = 1;
  expect_refused(kTriangle + "g a\nf 1 2 3\ng b\nf 1 2 3\n", {"line 7", "objects"}, limits);
  limits = {};
  limits.file_bytes = 10;
  expect_refused(kTriangle, {"file.obj"}, limits);
  std::string long_line = kTriangle + "f";
  for (int i = 0; i < 5000; ++i) long_line += " 1";
  expect_refused(long_line, {"line 4", "words"});
}

TEST_F(ObjTest, EveryBeginningOfAFileIsSafe) {
  write("file.mtl", "newmtl m\nKd 1 1 1\n");
  const std::string text = "mtllib file.mtl\no a\n" + kTriangle +
                           "vt 0 0\nvn 0 0 1\ns 1\nusemtl m\nf 1/1/1 2/1/1 3/1/-1\n";
  for (size_t size = 0; size <= text.size(); ++size) {
    const auto scene = load(std::string_view(text).substr(0, size));
    if (scene.ok()) continue;
    EXPECT_NE(scene.error().message.find("line "), std::string::npos) << size;
  }
}

TEST_F(ObjTest, BytesOfAnyKindAreSafe) {
  expect_refused(std::string("v 0 0 \0\n", 8), {"line 1"});
  EXPECT_TRUE(load(std::string("\0\0\0\n\xff\xfe", 6)).ok());
  EXPECT_TRUE(load("\\\n\\\n\\").ok());
  EXPECT_TRUE(load("").ok());
  // Extents beyond what a float holds the square of, and none at all.
  EXPECT_TRUE(load("v 3e38 0 0\nv -3e38 3e38 0\nv 0 -3e38 3e38\ns 1\nf 1 2 3\nf 1 1 1 1\n").ok());
}

TEST_F(ObjTest, FilesOutsideTheFolderAreNeverRead) {
  ASSERT_TRUE(write_file(folder_ / "secret.mtl", "newmtl m\nKd 1 0 0\n").ok());
  fs::create_symlink(folder_ / "secret.mtl", folder_ / "asset/link.mtl");
  for (const std::string& name :
       {std::string("../secret.mtl"), std::string("..\\secret.mtl"),
        (folder_ / "secret.mtl").string(), std::string("link.mtl"), std::string("C:\\secret.mtl"),
        std::string("x/../../secret.mtl")}) {
    const Scene scene = loaded("mtllib " + name + "\n" + kTriangle + "usemtl m\nf 1 2 3\n");
    EXPECT_EQ(scene.materials[0].name, "default") << name;
    EXPECT_FALSE(scene.warnings.empty()) << name;
  }
  const Scene scene = with_material("newmtl m\nmap_Kd ../../etc/passwd\nmap_Bump /etc/passwd\n");
  EXPECT_TRUE(scene.textures.empty());
  EXPECT_TRUE(warns_of(scene, "file.mtl: line 2"));
  EXPECT_TRUE(warns_of(scene, "file.mtl: line 3"));
}

TEST_F(ObjTest, MaterialsAreCheckedToo) {
  const std::string obj = "mtllib file.mtl\n" + kTriangle + "usemtl m\nf 1 2 3\n";
  write("file.mtl", "Kd 1 1 1\n");
  expect_refused(obj, {"file.mtl: line 1", "newmtl"});
  write("file.mtl", "newmtl m\nKd 1 nan 1\n");
  expect_refused(obj, {"file.mtl: line 2", "'nan'"});
  write("file.mtl", "newmtl m\nKe -1 0 0\n");
  expect_refused(obj, {"file.mtl: line 1", "Ke", "'m'"});
  write("file.mtl", "newmtl m\nKe 1e20 0 0\n");
  expect_refused(obj, {"file.mtl: line 1", "Ke"});
  write("picture.png", "no picture");
  write("file.mtl", "newmtl m\nmap_Kd picture.png\n");
  expect_refused(obj, {"picture.png", "neither PNG nor JPEG"});
  write("file.mtl", "newmtl m\nmap_Kd\nmap_Kd -s\nmap_Kd -s 1\nmap_Kd -o -\nmap_Kd -mm 1\n");
  EXPECT_TRUE(load(obj).ok());
}

}  // namespace
}  // namespace lueur
