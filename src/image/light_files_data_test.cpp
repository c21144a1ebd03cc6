// SPDX-License-Identifier: MIT
// Real EXR and Radiance files: they load, or are refused by name; damaged ones do no harm.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>

#include "image/exr.h"
#include "image/hdr.h"

namespace lueur {
namespace {
namespace fs = std::filesystem;

// Empty when it loads, else why it was refused.
std::string refusal_of(const fs::path& path) {
  Error error;
  if (path.extension() == ".hdr") {
    const auto image = read_hdr(path);
    if (image.ok()) return {};
    error = image.error();
  } else {
    const auto layers = read_exr(path);
    if (layers.ok()) return {};
    error = layers.error();
  }
  EXPECT_EQ(error.message.find('\n'), std::string::npos) << error.message;
  EXPECT_NE(error.message.find(path.filename().string()), std::string::npos) << error.message;
  return error.message;
}

TEST(LightFilesData, RealOnesLoad) {
  const char* data = std::getenv("LUEUR_DATA");
  if (!data) GTEST_SKIP() << "LUEUR_DATA is not set";
  int loaded = 0;
  for (const char* folder : {"hdr", "openexr_images/TestImages"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(data) / folder)) {
      const fs::path& path = entry.path();
      if (path.extension() != ".hdr" && path.extension() != ".exr") continue;
      const std::string refusal = refusal_of(path);
      // One is compressed with DWA.
      if (path.filename() == "apartment.exr")
        EXPECT_NE(refusal.find("DWA"), std::string::npos) << refusal;
      else
        EXPECT_EQ(refusal, "");
      if (refusal.empty()) ++loaded;
    }
  }
  EXPECT_GE(loaded, 14);
}

TEST(LightFilesData, DamagedOnesDoNoHarm) {
  const char* data = std::getenv("LUEUR_DATA");
  if (!data) GTEST_SKIP() << "LUEUR_DATA is not set";
  constexpr std::chrono::seconds kLongest(2);
  constexpr long kMostMemoryKiB = 512 * 1024;
  int count = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(data) / "openexr_images/Damaged")) {
    const auto start = std::chrono::steady_clock::now();
    refusal_of(entry.path());
    EXPECT_LT(std::chrono::steady_clock::now() - start, kLongest) << entry.path();
    ++count;
  }
  EXPECT_GT(count, 80);
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  EXPECT_LT(usage.ru_maxrss, kMostMemoryKiB);
}

}  // namespace
}  // namespace lueur
