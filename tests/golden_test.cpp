// SPDX-License-Identifier: MIT
// Whole pictures against stored ones. With LUEUR_GOLDEN_UPDATE=1 the pictures are stored anew; look
// at what changed before you keep them.
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>

#include "image/compare.h"
#include "image/png.h"
#include "image/tone_map.h"
#include "renderer/renderer.h"
#include "scene/builtin/builtin.h"
#include "support/gpu_test.h"

namespace lueur {
namespace {

constexpr Extent kExtent{192, 108};
// Drivers round differently, and a picture may move by that much: code values, share of the pixels.
constexpr uint8_t kTolerance = 5;
constexpr double kShare = 0.001;

struct Golden {
  const char* name;       // of the stored picture
  const char* scene;      // as on the command line
  const char* technique;  // nullptr: direct light only
  const char* image;      // of RenderedImages
  float brighter_ev = 0;  // stops above the scene's exposure
};

void PrintTo(const Golden& golden, std::ostream* out) {
  *out << golden.name;
}

constexpr Golden kGoldens[] = {
    {"cornell_direct", "cornell", nullptr, "composed"},
    {"cornell_hierarchical", "cornell", "hierarchical", "composed"},
    {"cornell_cube_map", "cornell", "cube_map", "composed"},
    {"cornell_indirect_lights", "cornell", "indirect_lights", "composed"},
    {"spot_floor_direct", "spot-floor", nullptr, "composed"},
    {"spot_floor_hierarchical", "spot-floor", "hierarchical", "composed"},
    {"atrium_direct", "atrium:triangles=20000", nullptr, "composed"},
    {"atrium_hierarchical", "atrium:triangles=20000", "hierarchical", "composed"},
    {"atrium_hierarchical_indirect", "atrium:triangles=20000", "hierarchical", "indirect", 3},
    {"atrium_indirect_lights", "atrium:triangles=20000", "indirect_lights", "composed"},
};

bool updating() {
  const char* value = std::getenv("LUEUR_GOLDEN_UPDATE");
  return value && std::strcmp(value, "1") == 0;
}

// Four times the difference, so that it can be seen.
Image8 difference_of(const Image8& a, const Image8& b) {
  Image8 difference = a;
  for (size_t i = 0; i < a.samples.size(); ++i)
    difference.samples[i] =
        static_cast<uint8_t>(std::min(255, 4 * std::abs(int{a.samples[i]} - int{b.samples[i]})));
  return difference;
}

class GoldenTest : public GpuTest, public testing::WithParamInterface<Golden> {
 protected:
  Image8 picture(const Golden& golden) {
    const auto scene = make_builtin_scene(golden.scene);
    EXPECT_TRUE(scene.ok());
    auto renderer = Renderer::create(system(), context(), *scene);
    EXPECT_TRUE(renderer.ok());
    std::unique_ptr<Technique> technique;
    if (golden.technique) technique = find_technique(golden.technique)->make();
    run([&](Frame& frame) {
      const Shot shot{.extent = kExtent, .seed = 1};
      const RenderedImages images = (*renderer)->record(frame, shot, technique.get());
      frame.recorder().read_back("composed", images.composed);
      frame.recorder().read_back("indirect", images.indirect);
    });
    const Pixels found = pixels(golden.image);
    ImageF light(found.extent.width, found.extent.height, 3);
    for (size_t i = 0; i < light.samples.size(); ++i)
      light.samples[i] = found.samples[i / 3 * found.channels + i % 3];
    const float exposure_ev = scene->exposure_ev.value_or(0.0f) + golden.brighter_ev;
    return to_display(light, exposure_ev, ToneMap::khronos_neutral);
  }
};

TEST_P(GoldenTest, PictureIsAsStored) {
  const Golden& golden = GetParam();
  const std::filesystem::path stored =
      std::filesystem::path(LUEUR_GOLDEN_FOLDER) / (std::string(golden.name) + ".png");
  const Image8 actual = picture(golden);
  ASSERT_FALSE(HasFailure());
  if (updating()) {
    const auto written = write_png(stored, actual);
    ASSERT_TRUE(written.ok()) << written.error().message;
    std::printf("stored anew: %s\n", stored.string().c_str());
    return;
  }

  auto expected = read_png(stored);
  ASSERT_TRUE(expected.ok()) << expected.error().message << "; `./run golden --update` stores it";
  // Files are read with alpha.
  Image8 opaque{actual.width, actual.height, 4, {}};
  for (size_t i = 0; i < actual.samples.size(); i += 3)
    opaque.samples.insert(opaque.samples.end(), {actual.samples[i], actual.samples[i + 1],
                                                 actual.samples[i + 2], uint8_t{255}});
  const auto difference = compare(opaque, *expected, kTolerance);
  ASSERT_TRUE(difference.ok()) << difference.error().message;
  if (difference->share_over <= kShare) return;

  // Show what it was and where it differs.
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "lueur_golden";
  std::filesystem::create_directories(folder);
  const auto actual_path = folder / (std::string(golden.name) + ".actual.png");
  const auto difference_path = folder / (std::string(golden.name) + ".difference.png");
  Image8 shown = difference_of(opaque, *expected);
  for (size_t i = 3; i < shown.samples.size(); i += 4) shown.samples[i] = 255;
  EXPECT_TRUE(write_png(actual_path, actual).ok());
  EXPECT_TRUE(write_png(difference_path, shown).ok());
  ADD_FAILURE() << std::to_string(100 * difference->share_over)
                << " % of the pixels differ by more than " << int{kTolerance} << ", by "
                << int{difference->max_channel} << " at most; " << std::to_string(100 * kShare)
                << " % may\n  stored:     " << stored.string()
                << "\n  actual:     " << actual_path.string()
                << "\n  difference: " << difference_path.string()
                << "\nIf the new picture is right, `./run golden --update " << golden.name
                << "` stores it.";
}

INSTANTIATE_TEST_SUITE_P(Pictures, GoldenTest, testing::ValuesIn(kGoldens),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace lueur
