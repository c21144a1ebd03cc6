// SPDX-License-Identifier: MIT
// Real OBJ files: the Cornell boxes of McGuire's archive.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "scene/deform.h"
#include "scene/obj_load.h"

namespace lueur {
namespace {
namespace fs = std::filesystem;

TEST(ObjCorpus, CornellBoxesLoadAndShine) {
  const char* data = std::getenv("LUEUR_DATA");
  if (!data) GTEST_SKIP() << "LUEUR_DATA is not set";
  int count = 0;
  for (const fs::directory_entry& entry :
       fs::directory_iterator(fs::path(data) / "cornell_mcguire")) {
    if (entry.path().extension() != ".obj") continue;
    ++count;
    const auto scene = load_obj(entry.path());
    ASSERT_TRUE(scene.ok()) << scene.error().message;
    bool shines = false;
    for (const Material& material : scene->materials)
      shines = shines || material.emission.r >= 10.0f;
    EXPECT_TRUE(shines) << entry.path();
    EXPECT_GE(triangle_count(*scene), 12u) << entry.path();
    const Bounds box = bounds_at(*scene, 0.0f);
    EXPECT_NEAR(box.max.x - box.min.x, 2.0f, 0.05f) << entry.path();
    EXPECT_NEAR(box.min.y, 0.0f, 0.01f) << entry.path();
  }
  EXPECT_EQ(count, 6);
}

}  // namespace
}  // namespace lueur
