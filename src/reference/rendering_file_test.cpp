// SPDX-License-Identifier: MIT
// Renderings on disk: whole, or not at all; the cache only ever helps.
#include "reference/rendering_file.h"

#include <stdlib.h>
#include <unistd.h>

#include "base/file.h"
#include "image/exr.h"
#include "reference/reference_fixture.h"

namespace lueur::reference {
namespace {

namespace fs = std::filesystem;

constexpr Shot kStored{16, 12};

// Has a folder of its own, which is the cache.
class RenderingFileTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "lueur_reference_test_XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    folder_ = name;
    ASSERT_EQ(::setenv("XDG_CACHE_HOME", folder_.c_str(), 1), 0);
    scene_ = inside_box();
    scene_.materials[0].emission = glm::vec3(0.3f, 0.2f, 0.1f);
  }
  void TearDown() override { fs::remove_all(folder_); }

  CachedRendering cached(const Settings& settings = {.spp = 16}, const Control& control = {}) {
    auto result = render_cached(scene_, kStored, settings, control);
    EXPECT_TRUE(result.ok()) << result.error().message;
    return result.ok() ? std::move(*result) : CachedRendering{};
  }
  std::vector<fs::path> kept() const {
    std::vector<fs::path> files;
    if (fs::exists(folder_ / "lueur/references"))
      for (const auto& entry : fs::directory_iterator(folder_ / "lueur/references"))
        files.push_back(entry.path());
    return files;
  }

  fs::path folder_;
  Scene scene_;
};

TEST_F(RenderingFileTest, IsReadAsItWasWritten) {
  const Rendering r = rendered(scene_, kStored, {.spp = 16});
  ASSERT_TRUE(write_rendering(folder_ / "r.exr", r, {{"lueur.scene", "box"}}).ok());
  const auto back = read_rendering(folder_ / "r.exr");
  ASSERT_TRUE(back.ok()) << back.error().message;
  EXPECT_TRUE(same_layers(r, *back));
  EXPECT_TRUE(back->complete);
  EXPECT_EQ(back->progress.spp_done, 16u);
  EXPECT_EQ(back->progress.relative_error, r.progress.relative_error);
  EXPECT_EQ(back->progress.rays, r.progress.rays);
}

TEST_F(RenderingFileTest, OtherFilesAreRefused) {
  ASSERT_TRUE(write_file(folder_ / "noise.exr", "no picture").ok());
  const ImageLayer picture{"", ImageF(2, 2, 3)};
  ASSERT_TRUE(write_exr(folder_ / "other.exr", {&picture, 1}).ok());
  for (const char* name : {"noise.exr", "other.exr", "missing.exr"}) {
    const auto r = read_rendering(folder_ / name);
    ASSERT_FALSE(r.ok()) << name;
    EXPECT_EQ(r.error().kind, ErrorKind::input);
    EXPECT_NE(r.error().message.find(name), std::string::npos) << r.error().message;
  }
}

TEST_F(RenderingFileTest, SecondTimeComesFromTheCache) {
  for (const Settings& settings : {Settings{.spp = 16}, Settings{.mode = Mode::ambient, .spp = 16},
                                   Settings{.mode = Mode::screen, .spp = 16},
                                   Settings{.mode = Mode::screen_unoccluded, .spp = 0}}) {
    const CachedRendering first = cached(settings), second = cached(settings);
    EXPECT_FALSE(first.from_cache);
    EXPECT_TRUE(second.from_cache);
    EXPECT_EQ(first.cache_note + second.cache_note, "");
    EXPECT_TRUE(same_layers(first.rendering, second.rendering));
    EXPECT_EQ(second.rendering.progress.spp_done, first.rendering.progress.spp_done);
    EXPECT_TRUE(second.rendering.complete);
  }
  EXPECT_EQ(kept().size(), 4u);
  EXPECT_FALSE(cached({.spp = 24}).from_cache);
  scene_.materials[0].emission.r = 0.4f;
  EXPECT_FALSE(cached().from_cache);
}

TEST_F(RenderingFileTest, DamagedFilesAreMadeAnew) {
  const CachedRendering first = cached();
  ASSERT_EQ(kept().size(), 1u);
  const fs::path file = kept()[0];
  auto bytes = read_file(file, 1u << 24);
  ASSERT_TRUE(bytes.ok());
  std::vector<uint8_t> flipped = *bytes;
  flipped[flipped.size() / 2] ^= 0x10;
  for (const std::vector<uint8_t>& damage :
       {std::vector<uint8_t>(), std::vector<uint8_t>(bytes->begin(), bytes->begin() + 300),
        std::vector<uint8_t>(bytes->begin(), bytes->end() - 1), flipped}) {
    ASSERT_TRUE(write_file(file, damage).ok());
    const CachedRendering again = cached();
    EXPECT_FALSE(again.from_cache) << damage.size() << " bytes";
    EXPECT_NE(again.cache_note.find("made anew"), std::string::npos) << again.cache_note;
    EXPECT_TRUE(same_layers(first.rendering, again.rendering));
    EXPECT_TRUE(cached().from_cache);
  }
}

TEST_F(RenderingFileTest, WithoutACacheItRendersAllTheSame) {
  const CachedRendering first = cached();
  // A file where the folder would be: not even root can write there.
  fs::remove_all(folder_ / "lueur");
  ASSERT_TRUE(write_file(folder_ / "lueur", "a file").ok());
  const CachedRendering second = cached();
  EXPECT_FALSE(second.from_cache);
  EXPECT_NE(second.cache_note.find("references"), std::string::npos) << second.cache_note;
  EXPECT_TRUE(same_layers(first.rendering, second.rendering));
}

// What is stopped early is not what was asked for.
TEST_F(RenderingFileTest, PartsAreNotKept) {
  std::stop_source stop;
  stop.request_stop();
  const CachedRendering part = cached({.spp = 16}, {.stop = stop.get_token()});
  EXPECT_FALSE(part.rendering.complete);
  EXPECT_EQ(kept().size(), 0u);
}

// A state with more samples than are asked for now ends at once, but is not the rendering that
// this many samples give: it must not take that one's place.
TEST_F(RenderingFileTest, LongerStatesAreNotKept) {
  std::vector<uint8_t> state;
  Control control{.checkpoint = [&](const std::vector<uint8_t>& s) { state = s; },
                  .checkpoint_s = 0};
  rendered(scene_, kStored, {.spp = 64}, control);
  const auto more = render_cached(scene_, kStored, {.spp = 16}, {}, state);
  ASSERT_TRUE(more.ok());
  EXPECT_EQ(more->rendering.progress.spp_done, 64u);
  const CachedRendering plain = cached({.spp = 16});
  EXPECT_EQ(plain.rendering.progress.spp_done, 16u);
  EXPECT_TRUE(same_layers(plain.rendering, rendered(scene_, kStored, {.spp = 16})));
}

}  // namespace
}  // namespace lueur::reference
