// SPDX-License-Identifier: MIT
// Broken promises of a pass stop the program and name the pass and the shader.
#include "frame/recorder.h"
#include "frame/test_shaders/params.h"
#include "frame/test_shaders/shaders.h"
#include "support/gpu_test.h"

namespace lueur {
namespace {

constexpr Extent kFew{4, 4};

class RecorderDeathTest : public GpuTest {
 protected:
  void SetUp() override {
    // The driver has threads of its own.
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    GpuTest::SetUp();
  }
  Image ones() {
    const std::vector<vec4> pixels(16, vec4(1.0f));
    return recorder().upload_image("ones", kFew, Format::rgba32f, pixels.data());
  }
  Image target(Format format = Format::rgba32f) { return recorder().image("target", kFew, format); }
  void dispatch(std::vector<Bound> read, std::vector<Bound> write,
                const Params& params = CopyParams{ivec2(4, 4), 0.0f}) {
    recorder().dispatch("test.pass", {.shader = shaders::frame_test_shaders_copy_comp,
                                      .params = params,
                                      .read = std::move(read),
                                      .write = std::move(write),
                                      .over = kFew});
  }
};

// The message: pass, shader, and what is wrong.
#define EXPECT_BROKEN(statement, what)          \
  EXPECT_DEATH(run([&](Frame&) { statement; }), \
               "broken promise.*pass test\\.pass, shader frame/test_shaders/copy\\.comp: " what)

TEST_F(RecorderDeathTest, NamesMustBeTheShaders) {
  EXPECT_BROKEN(dispatch({{"fron", ones()}}, {{"to", target()}}), "it has no binding fron");
  EXPECT_BROKEN(dispatch({}, {{"to", target()}}), "nothing is bound to from");
}

TEST_F(RecorderDeathTest, AReadIsNotAWrite) {
  EXPECT_BROKEN(dispatch({{"from", ones()}, {"to", ones()}}, {}), "to is written by the shader");
}

TEST_F(RecorderDeathTest, FormatsMustBeTheShaders) {
  EXPECT_BROKEN(dispatch({{"from", ones()}}, {{"to", target(Format::rgba16f)}}),
                "to is rgba16f, which is not the shader's format");
}

TEST_F(RecorderDeathTest, ParametersMustHaveTheShadersSize) {
  EXPECT_BROKEN(dispatch({{"from", ones()}}, {{"to", target()}}, ivec2(4, 4)),
                "params has 8 bytes, the push constants 12");
}

TEST_F(RecorderDeathTest, NothingIsReadBeforeItIsWritten) {
  EXPECT_BROKEN(dispatch({{"from", target()}}, {{"to", target()}}),
                "from is read before it was written");
}

TEST_F(RecorderDeathTest, NothingIsUsedAfterItsRelease) {
  const auto use_released = [&] {
    const Image image = ones();
    recorder().release(image);
    // Of another size, or it would be the released image itself.
    dispatch({{"from", image}}, {{"to", recorder().image("to", {4, 5}, Format::rgba32f)}});
  };
  EXPECT_BROKEN(use_released(), "from was released");
}

TEST_F(RecorderDeathTest, TheEnginesBuffersAreNotWritten) {
  const auto write_lent = [&](Frame& frame) {
    const std::vector<uint32_t> numbers(4);
    recorder().dispatch("test.pass", {.shader = shaders::frame_test_shaders_double_comp,
                                      .read = {{"numbers", recorder().upload(numbers)}},
                                      .write = {{"doubled", frame.import(ExternalBuffer{})}},
                                      .over = {4, 1}});
  };
  EXPECT_DEATH(run([&](Frame& frame) { write_lent(frame); }),
               "pass test\\.pass, .*doubled is the engine's, to be read only");
}

TEST_F(RecorderDeathTest, CopiesKeepExtentAndFormat) {
  EXPECT_DEATH(run([&](Frame& frame) { frame.copy(ones(), target(Format::rgba16f)); }),
               "broken promise.*from\\.format == to\\.format");
  EXPECT_DEATH(run([&](Frame& frame) {
                 frame.copy(ones(), recorder().image("to", {4, 5}, Format::rgba32f));
               }),
               "broken promise.*from\\.extent == to\\.extent");
  EXPECT_DEATH(run([&](Frame& frame) { frame.copy(target(), target()); }),
               "broken promise.*written");
}

}  // namespace
}  // namespace lueur
