// SPDX-License-Identifier: MIT
#include "base/file.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

namespace lueur {
namespace {
namespace fs = std::filesystem;

class FileTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "lueur-file-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path folder_;
};

TEST_F(FileTest, WhatIsWrittenIsReadBack) {
  ASSERT_TRUE(write_file(folder_ / "a", std::string_view("light")).ok());
  const auto bytes = read_file(folder_ / "a", 100);
  ASSERT_TRUE(bytes.ok());
  EXPECT_EQ(std::string(bytes->begin(), bytes->end()), "light");
}

TEST_F(FileTest, FailedWriteLeavesTheOldContentAndNothingElse) {
  ASSERT_TRUE(write_file(folder_ / "a", std::string_view("old")).ok());
  const auto missing = write_file(folder_ / "none" / "a", std::string_view("x"));
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().kind, ErrorKind::output);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(FileTest, PendingUntilCommitted) {
  ASSERT_TRUE(write_file(folder_ / "a", std::string_view("old")).ok());
  const auto content = [&] {
    const auto bytes = read_file(folder_ / "a", 100);
    return bytes.ok() ? std::string(bytes->begin(), bytes->end()) : std::string("unreadable");
  };
  const auto files = [&] {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  };
  {
    auto file = PendingFile::create(folder_ / "a");
    ASSERT_TRUE(file.ok());
    EXPECT_EQ(write_all(file->descriptor(), std::string_view("left out")), 0);
    const PendingFile moved = std::move(*file);
    EXPECT_EQ(files(), 2);
  }
  EXPECT_EQ(files(), 1);
  EXPECT_EQ(content(), "old");

  auto file = PendingFile::create(folder_ / "a");
  ASSERT_TRUE(file.ok());
  EXPECT_EQ(file->temporary().parent_path(), folder_);
  EXPECT_EQ(write_all(file->descriptor(), std::string_view("new")), 0);
  EXPECT_EQ(content(), "old");
  ASSERT_TRUE(file->commit().ok());
  EXPECT_EQ(content(), "new");
  EXPECT_EQ(files(), 1);
  // Like any new file, and not private as a temporary one.
  std::ofstream(folder_ / "plain") << "x";
  EXPECT_EQ(fs::status(folder_ / "a").permissions(), fs::status(folder_ / "plain").permissions());
}

TEST_F(FileTest, FullDiskIsAnError) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const auto full = write_file("/dev/full", std::string_view("x"));
  ASSERT_FALSE(full.ok());
  EXPECT_NE(full.error().message.find("/dev/full"), std::string::npos);
}

TEST_F(FileTest, ReadsAreCappedAndNamed) {
  ASSERT_TRUE(write_file(folder_ / "a", std::string_view("12345")).ok());
  EXPECT_FALSE(read_file(folder_ / "a", 4).ok());
  EXPECT_TRUE(read_file(folder_ / "a", 5).ok());
  EXPECT_FALSE(read_file(folder_, 5).ok());
  EXPECT_EQ(read_file(folder_ / "b", 5).error().kind, ErrorKind::input);
}

}  // namespace
}  // namespace lueur
