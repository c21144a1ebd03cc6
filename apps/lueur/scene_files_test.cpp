// SPDX-License-Identifier: MIT
#include "scene_files.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "scene/builtin/builtin.h"

namespace lueur::cli {
namespace {
namespace fs = std::filesystem;

class SceneFilesTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "lueur-scenes-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    base_ = fs::canonical(pattern);
    folder_ = base_ / "models";
    fs::create_directory(folder_);
  }
  void TearDown() override { fs::remove_all(base_); }

  void touch(const fs::path& path) const {
    fs::create_directories((folder_ / path).parent_path());
    std::ofstream(folder_ / path) << "x";
  }

  static std::vector<std::string> labels(const std::vector<std::string>& arguments) {
    const auto found = find_scenes(arguments);
    EXPECT_TRUE(found.ok()) << found.error().message;
    std::vector<std::string> list;
    if (found.ok())
      for (const SceneSource& source : *found) list.push_back(source.label);
    return list;
  }

  fs::path base_;
  fs::path folder_;
};

using Names = std::vector<std::string>;

TEST_F(SceneFilesTest, NothingMeansAllBuiltins) {
  const Names all = labels({});
  ASSERT_EQ(all.size(), builtin_scenes().size());
  for (size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i], builtin_scenes()[i].name);
}

TEST_F(SceneFilesTest, FoldersAreSearchedAndSorted) {
  touch("b/box.glb");
  touch("b.glb");
  touch("a.GLTF");
  touch("a.bin");
  touch("glb");
  fs::create_directory(folder_ / "folder.glb");
  // Path by path: a folder's files come before a file whose name goes on after the folder's.
  const Names expected = {"models/a.GLTF", "models/b/box.glb", "models/b.glb"};
  EXPECT_EQ(labels({folder_.string()}), expected);
  EXPECT_EQ(labels({folder_.string() + "/"}), expected);
  const auto found = find_scenes({folder_.string()});
  ASSERT_TRUE(found.ok());
  EXPECT_EQ((*found)[1].spec, (folder_ / "b/box.glb").string());
}

TEST_F(SceneFilesTest, ArgumentsKeepTheirOrder) {
  touch("a.glb");
  const Names expected = {"cornell:x=1", "models/a.glb", "missing.glb"};
  EXPECT_EQ(labels({"cornell:x=1", folder_.string(), "missing.glb"}), expected);
}

TEST_F(SceneFilesTest, LinksToFoldersAreNotFollowed) {
  touch("a.glb");
  fs::create_directory_symlink(folder_, folder_ / "again");
  fs::create_symlink(folder_ / "a.glb", folder_ / "link.glb");
  EXPECT_EQ(labels({folder_.string()}), (Names{"models/a.glb", "models/link.glb"}));
}

TEST_F(SceneFilesTest, AFolderWithoutScenesIsAnError) {
  touch("readme.txt");
  const auto found = find_scenes({"cornell", folder_.string()});
  ASSERT_FALSE(found.ok());
  EXPECT_EQ(found.error().kind, ErrorKind::input);
  EXPECT_TRUE(found.error().message.starts_with(folder_.string() + ": "));
}

}  // namespace
}  // namespace lueur::cli
