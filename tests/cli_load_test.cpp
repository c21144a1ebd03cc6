// SPDX-License-Identifier: MIT
// How long scenes take to load, and how much memory beside their own.
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "support/cli.h"

namespace lueur {
namespace {

class CliLoad : public Cli {
 protected:
  // Loads the scene three times, as another process may be in the way.
  void expect_quick(const std::string& scene) const {
    constexpr double kMostMs = 2000.0;
    constexpr uint64_t kProgramBytes = uint64_t{24} << 20;  // code and libraries, without a scene
    double load_ms = 1e9;
    for (int i = 0; i < 3; ++i) {
      const Ended ended = run({"scene", "info", scene, "--json"});
      ASSERT_EQ(ended.code, 0) << ended.err;
      const auto info = nlohmann::json::parse(ended.out);
      load_ms = std::min(load_ms, info["load_ms"].get<double>());
      const auto data = info["data_bytes"].get<uint64_t>();
      EXPECT_LE(ended.peak_bytes, 2 * data + kProgramBytes);
      if (i == 0)
        std::printf("%s: %.1f MB of data, %.1f MB at the most\n", scene.c_str(),
                    static_cast<double>(data) / 1e6, static_cast<double>(ended.peak_bytes) / 1e6);
    }
    std::printf("%s: %.0f ms\n", scene.c_str(), load_ms);
    EXPECT_LE(load_ms, kMostMs);
  }
};

TEST_F(CliLoad, AMillionTrianglesTakeLessThanTwoSeconds) {
  ASSERT_EQ(run({"scene", "export", "atrium:triangles=1000000", "-o", "million.glb"}).code, 0);
  expect_quick("million.glb");
}

TEST_F(CliLoad, SponzaTakesLessThanTwoSeconds) {
  const char* data = std::getenv("LUEUR_DATA");
  if (!data) GTEST_SKIP() << "LUEUR_DATA is not set";
  expect_quick(std::string(data) + "/sponza_crytek/sponza.glb");
}

}  // namespace
}  // namespace lueur
