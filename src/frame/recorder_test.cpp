// SPDX-License-Identifier: MIT
// The life of a frame: pooled memory, history, uploads, imported images, errors and timers.
#include "frame/recorder.h"

#include <cstring>

#include "frame/test_shaders/params.h"
#include "frame/test_shaders/shaders.h"
#include "gpu/format.h"
#include "support/gpu_test.h"

namespace lueur {
namespace {

constexpr Extent kSmall{16, 8};
constexpr Extent kTooLarge{100'000, 1};

class RecorderTest : public GpuTest {
 protected:
  // Writes `to` = `from` + `add`.
  void copy(const std::string& pass, Image from, Image to, float add = 0.0f) {
    recorder().dispatch(pass, {.shader = shaders::frame_test_shaders_copy_comp,
                               .params = CopyParams{as_ivec2(to.extent), add},
                               .read = {{"from", from}},
                               .write = {{"to", to}},
                               .over = to.extent});
  }
  Image constant(const char* name, Extent extent, float value) {
    const std::vector<float> pixels(size_t{extent.width} * extent.height * 4, value);
    return recorder().upload_image(name, extent, Format::rgba32f, pixels.data());
  }
  // A frame that is meant to fail.
  Error failure(const std::function<void(Frame&)>& record) {
    const auto result = system().run([&](VkCommandBuffer commands) {
      Frame frame = context().record(commands);
      record(frame);
      return frame.finish();
    });
    if (result.ok()) {
      ADD_FAILURE() << "the frame should have failed";
      return {};
    }
    return result.error();
  }
  void expect_all(const std::string& name, float value) {
    const Pixels p = pixels(name);
    ASSERT_FALSE(p.samples.empty());
    for (const float sample : p.samples) ASSERT_EQ(sample, value) << name;
  }
};

TEST_F(RecorderTest, ReleasedImagesAreUsedAgain) {
  run([&](Frame&) {
    const Image first = recorder().image("first", kSmall, Format::rgba16f);
    EXPECT_NE(recorder().image("beside", kSmall, Format::rgba16f).index, first.index);
    recorder().release(first);
    EXPECT_NE(recorder().image("other format", kSmall, Format::r16f).index, first.index);
    EXPECT_NE(recorder().image("other size", {8, 16}, Format::rgba16f).index, first.index);
    EXPECT_NE(recorder().cube("cube", 16, Format::d32f).index, first.index);
    EXPECT_EQ(recorder().image("second", kSmall, Format::rgba16f).index, first.index);
  });
}

TEST_F(RecorderTest, MemoryDoesNotGrowOverFrames) {
  const auto frame = [&](Frame&) {
    const Image a = constant("a", {64, 64}, 1.0f);
    const Image b = recorder().image("b", {64, 64}, Format::rgba32f);
    copy("test.copy", a, b);
    recorder().buffer("buffer", 4096);
    recorder().cube("cube", 32, Format::d32f);
    const HistoryImage h = recorder().history("h", {32, 32}, Format::rgba32f);
    copy("test.history", b, h.current);
  };
  const uint64_t before = recorder().memory().total_bytes;
  run(frame);
  const MemoryUse after_one = recorder().memory();
  // Two images, the upload, two history images, the cube and the buffer, at least.
  EXPECT_GE(after_one.total_bytes,
            before + 3 * 65536 + 2 * 16384 + 6 * uint64_t{32 * 32 * 4} + 4096);
  for (int i = 0; i < 20; ++i) {
    run(frame);
    ASSERT_EQ(recorder().memory().total_bytes, after_one.total_bytes) << "frame " << i;
  }
  EXPECT_EQ(recorder().memory().peak_bytes, after_one.peak_bytes);
  EXPECT_GE(after_one.peak_bytes, after_one.total_bytes);
}

TEST_F(RecorderTest, IdleImagesGiveTheirMemoryBack) {
  const auto nothing = [](Frame&) {};
  run(nothing);
  const uint64_t empty = recorder().memory().total_bytes;
  run([&](Frame&) { recorder().image("large", {256, 256}, Format::rgba32f); });
  const uint64_t held = recorder().memory().total_bytes;
  EXPECT_GE(held, empty + uint64_t{256 * 256 * 16});
  for (int i = 0; i < 16; ++i) run(nothing);
  EXPECT_EQ(recorder().memory().total_bytes, held);
  run(nothing);
  EXPECT_EQ(recorder().memory().total_bytes, empty);
  EXPECT_GE(recorder().memory().peak_bytes, held);
  // The place of a freed image serves the next one.
  run([&](Frame&) { recorder().image("large", {256, 256}, Format::rgba32f); });
  EXPECT_EQ(recorder().memory().total_bytes, held);

  // How long is idle can be chosen, and buffers follow the same rule.
  recorder().options.idle_frames = 100;
  for (int i = 0; i < 30; ++i) run(nothing);
  EXPECT_EQ(recorder().memory().total_bytes, held);
  recorder().options.idle_frames = 0;
  run([&](Frame&) { recorder().buffer("buffer", 4096); });
  EXPECT_EQ(recorder().memory().total_bytes, empty + 4096);
  run(nothing);
  EXPECT_EQ(recorder().memory().total_bytes, empty);
}

TEST_F(RecorderTest, HistoryHoldsThePreviousFrame) {
  const auto count_up = [&](bool expect_valid) {
    run([&](Frame&) {
      const HistoryImage h = recorder().history("sum", kSmall, Format::rgba32f);
      EXPECT_EQ(h.valid, expect_valid);
      EXPECT_NE(h.previous.index, h.current.index);
      copy("test.count", h.valid ? h.previous : constant("zero", kSmall, 0.0f), h.current, 1.0f);
      recorder().read_back("sum", h.current);
    });
  };
  for (int frame = 0; frame < 4; ++frame) {
    count_up(frame > 0);
    expect_all("sum", static_cast<float>(frame + 1));
  }
  // A frame that does not use it breaks the chain.
  run([](Frame&) {});
  count_up(false);
  expect_all("sum", 1.0f);
  count_up(true);
  expect_all("sum", 2.0f);
  recorder().forget_history();
  count_up(false);
  expect_all("sum", 1.0f);
}

// Views that take turns, one of them in another size, each see their own past alone.
TEST_F(RecorderTest, HistoriesInTurnDoNotMix) {
  const auto count_up = [&](const std::string& of, Extent extent, float step) {
    recorder().options.history_of = of;
    bool valid = false;
    run([&](Frame&) {
      const HistoryImage h = recorder().history("sum", extent, Format::rgba32f);
      valid = h.valid;
      copy("test.count", h.valid ? h.previous : constant("zero", extent, 0.0f), h.current, step);
      recorder().read_back("sum", h.current);
    });
    return valid;
  };
  uint64_t held = 0;
  for (int round = 1; round <= 3; ++round) {
    EXPECT_EQ(count_up("a", kSmall, 1.0f), round > 1);
    expect_all("sum", static_cast<float>(round));
    EXPECT_EQ(count_up("b", kSmall, 10.0f), round > 1);
    expect_all("sum", static_cast<float>(10 * round));
    EXPECT_EQ(count_up("c", {8, 8}, 100.0f), round > 1);
    expect_all("sum", static_cast<float>(100 * round));
    if (round == 1) held = recorder().memory().total_bytes;
  }
  // Another size in between allocates nothing anew.
  EXPECT_EQ(recorder().memory().total_bytes, held);
  // One's own frame without it still ends it, for this one alone.
  recorder().options.history_of = "a";
  run([](Frame&) {});
  EXPECT_FALSE(count_up("a", kSmall, 1.0f));
  EXPECT_TRUE(count_up("b", kSmall, 10.0f));
  recorder().forget_history();
  EXPECT_FALSE(count_up("a", kSmall, 1.0f));
  EXPECT_FALSE(count_up("b", kSmall, 10.0f));
}

TEST_F(RecorderTest, HistoryOfOtherExtentOrFormatStartsAnew) {
  const auto use = [&](Extent extent, Format format) {
    bool valid = false;
    run([&](Frame&) {
      const HistoryImage h = recorder().history("h", extent, format);
      EXPECT_EQ(h.current.extent, extent);
      EXPECT_EQ(h.current.format, format);
      valid = h.valid;
    });
    return valid;
  };
  EXPECT_FALSE(use(kSmall, Format::rgba32f));
  EXPECT_TRUE(use(kSmall, Format::rgba32f));
  EXPECT_FALSE(use({8, 8}, Format::rgba32f));
  EXPECT_TRUE(use({8, 8}, Format::rgba32f));
  EXPECT_FALSE(use({8, 8}, Format::r32f));
}

TEST_F(RecorderTest, HistoryIsNeverHandedOutAsATransientImage) {
  run([&](Frame&) {
    const HistoryImage h = recorder().history("h", kSmall, Format::rgba32f);
    for (int i = 0; i < 4; ++i) {
      const Image image = recorder().image("other", kSmall, Format::rgba32f);
      EXPECT_NE(image.index, h.current.index);
      EXPECT_NE(image.index, h.previous.index);
    }
  });
}

// What this very frame reads must live until the frame is done, however old it is.
TEST_F(RecorderTest, HistoryForgottenWithinAFrameOutlivesTheFrame) {
  const auto use = [&] {
    const HistoryImage h = recorder().history("h", kSmall, Format::rgba32f);
    copy("test.copy", h.valid ? h.previous : constant("zero", kSmall, 0.0f), h.current);
  };
  for (int i = 0; i < 20; ++i) run([&](Frame&) { use(); });
  run([&](Frame&) {
    use();
    recorder().forget_history();
  });
}

TEST_F(RecorderTest, AFailedFrameLeavesNoHistory) {
  run([&](Frame&) {
    copy("test.copy", constant("zero", kSmall, 0.0f),
         recorder().history("h", kSmall, Format::rgba32f).current);
  });
  failure([&](Frame&) {
    EXPECT_TRUE(recorder().history("h", kSmall, Format::rgba32f).valid);
    recorder().image("too large", kTooLarge, Format::r8);
  });
  run([&](Frame&) { EXPECT_FALSE(recorder().history("h", kSmall, Format::rgba32f).valid); });
}

TEST_F(RecorderTest, HistoryThatCannotBeMadeFailsOnlyItsFrame) {
  const auto use = [&](Extent extent) { return recorder().history("h", extent, Format::rgba32f); };
  // Without anything in the pool, and in place of an older one.
  const Error error = failure([&](Frame&) { EXPECT_FALSE(use(kTooLarge).current.valid()); });
  EXPECT_EQ(error.kind, ErrorKind::usage);
  run([&](Frame&) { use(kSmall); });
  failure([&](Frame&) { use(kTooLarge); });
  run([&](Frame&) {
    const HistoryImage h = use(kSmall);
    EXPECT_FALSE(h.valid);
    const Image other = recorder().image("other", kSmall, Format::rgba32f);
    EXPECT_NE(other.index, h.current.index);
    EXPECT_NE(other.index, h.previous.index);
  });
}

TEST_F(RecorderTest, BuffersOfAnySizePassThrough) {
  // Three times the size of one chunk of uploads.
  constexpr Extent kExtent{1024, 768};
  std::vector<uint32_t> numbers(size_t{kExtent.width} * kExtent.height);
  for (size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<uint32_t>(i);
  run([&](Frame&) {
    // A small upload before and after, so that chunks are shared and changed.
    const std::vector<uint32_t> few = {7, 8, 9, 10};
    const BufferRef before = recorder().upload(few);
    const BufferRef uploaded = recorder().upload(numbers);
    const BufferRef after = recorder().upload(few);
    const BufferRef doubled = recorder().buffer("doubled", numbers.size() * sizeof(uint32_t));
    recorder().dispatch("test.double", {.shader = shaders::frame_test_shaders_double_comp,
                                        .read = {{"numbers", uploaded}},
                                        .write = {{"doubled", doubled}},
                                        .over = {static_cast<uint32_t>(numbers.size()), 1}});
    const auto show = [&](const char* name, BufferRef buffer, Extent extent) {
      const Image shown = recorder().image(name, extent, Format::r32ui);
      recorder().dispatch("test.show", {.shader = shaders::frame_test_shaders_show_comp,
                                        .read = {{"numbers", buffer}},
                                        .write = {{"shown", shown}},
                                        .over = extent});
      recorder().read_back(name, shown);
    };
    show("before", before, {4, 1});
    show("doubled", doubled, kExtent);
    show("after", after, {4, 1});
  });
  EXPECT_EQ(pixels("before").samples, (std::vector<float>{7, 8, 9, 10}));
  EXPECT_EQ(pixels("after").samples, (std::vector<float>{7, 8, 9, 10}));
  const Pixels doubled = pixels("doubled");
  ASSERT_EQ(doubled.samples.size(), numbers.size());
  for (size_t i = 0; i < numbers.size(); ++i)
    ASSERT_EQ(doubled.samples[i], static_cast<float>(2 * i));  // below 2^24: exact
}

// Two by two workgroups, of eight by eight threads, by what a pass before has written: half of the
// image. Synchronization validation watches.
TEST_F(RecorderTest, EarlierPassesSayHowManyWorkgroupsRun) {
  constexpr Extent kWide{32, 16};
  run([&](Frame&) {
    const BufferRef groups = recorder().buffer("groups", 3 * sizeof(uint32_t));
    recorder().dispatch("test.groups",
                        {.shader = shaders::frame_test_shaders_double_comp,
                         .read = {{"numbers", recorder().upload(std::vector<uint32_t>{1, 1, 1})}},
                         .write = {{"doubled", groups}},
                         .over = {3, 1}});
    const Image from = constant("from", kWide, 1.0f);
    const Image to = recorder().image("to", kWide, Format::rgba32f);
    copy("test.all", from, to);
    recorder().dispatch("test.some", {.shader = shaders::frame_test_shaders_copy_comp,
                                      .params = CopyParams{as_ivec2(kWide), 4.0f},
                                      .read = {{"from", from}},
                                      .write = {{"to", to}},
                                      .groups = groups});
    recorder().read_back("to", to);
  });
  const Pixels to = pixels("to");
  ASSERT_EQ(to.samples.size(), size_t{kWide.width} * kWide.height * 4);
  for (size_t i = 0; i < to.samples.size(); ++i)
    ASSERT_EQ(to.samples[i], i / 4 % kWide.width < 16 ? 5.0f : 1.0f) << i;
}

// An engine's image: cleared by the engine, added to by a pass of ours, and used by the engine
// again in the same command buffer. Synchronization validation watches.
class ImportTest : public RecorderTest, public testing::WithParamInterface<VkImageLayout> {};

TEST_P(ImportTest, ImageComesBackAsItWasLent) {
  const VkImageLayout layout = GetParam();
  constexpr VkPipelineStageFlags2 kStage = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
  constexpr VkAccessFlags2 kAccess = VK_ACCESS_2_TRANSFER_READ_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT;
  gpu::Device& device = recorder().device();
  auto made = gpu::Texture::create(device, {.name = "engine's",
                                            .extent = kSmall,
                                            .format = Format::rgba32f,
                                            .usage = gpu::general_usage(Format::rgba32f)});
  ASSERT_TRUE(made.ok()) << made.error().message;
  const gpu::Texture& texture = *made;
  constexpr uint64_t kBytes = uint64_t{kSmall.width} * kSmall.height * 16;
  auto buffer = gpu::Buffer::create(device, {.name = "engine's copy",
                                             .bytes = kBytes,
                                             .usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                             .kind = gpu::MemoryKind::readback});
  ASSERT_TRUE(buffer.ok()) << buffer.error().message;

  const auto result = system().run([&](VkCommandBuffer handle) -> Result<void> {
    gpu::CommandList commands(handle, false);
    const auto change = [&](VkImageLayout from, VkImageLayout to, VkPipelineStageFlags2 stage) {
      const gpu::ImageTransition t{
          texture.handle(),
          VK_IMAGE_ASPECT_COLOR_BIT,
          {stage, stage ? kAccess : VK_ACCESS_2_NONE, kStage, kAccess, from, to}};
      commands.barrier(std::span(&t, 1), {});
    };
    change(VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 0);
    const VkClearColorValue quarter{{0.25f, 0.25f, 0.25f, 0.25f}};
    const VkImageSubresourceRange all{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    vkCmdClearColorImage(handle, texture.handle(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &quarter,
                         1, &all);
    change(VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, layout, kStage);

    Frame frame = context().record(handle);
    const Image lent = frame.import({.image = texture.handle(),
                                     .view = texture.view(),
                                     .format = Format::rgba32f,
                                     .extent = kSmall,
                                     .layout = layout,
                                     .last_stage = kStage,
                                     .last_access = kAccess});
    const Image seen = recorder().image("seen", kSmall, Format::rgba32f);
    copy("test.see", lent, seen, 1.0f);
    copy("test.write_back", seen, lent, 1.0f);
    recorder().read_back("seen", seen);
    if (auto finished = frame.finish(); !finished.ok()) return finished;

    change(layout, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, kStage);
    commands.copy_to_buffer(texture.handle(), VK_IMAGE_ASPECT_COLOR_BIT, buffer->handle(),
                            {.extent = kSmall});
    return {};
  });
  ASSERT_TRUE(result.ok()) << result.error().message;
  expect_all("seen", 1.25f);
  buffer->invalidate();
  std::vector<float> engine_sees(kBytes / sizeof(float));
  std::memcpy(engine_sees.data(), buffer->mapped().data(), kBytes);
  EXPECT_EQ(engine_sees, std::vector<float>(engine_sees.size(), 2.25f));
  // It is the engine's memory.
  run([](Frame&) {});
  EXPECT_TRUE(system().validation_messages().empty());
}

INSTANTIATE_TEST_SUITE_P(Layouts, ImportTest,
                         testing::Values(VK_IMAGE_LAYOUT_GENERAL,
                                         VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL));

// An engine's buffer, filled by the engine in the same command buffer. Synchronization validation
// watches.
TEST_F(RecorderTest, ImportedBuffersAreReadAfterTheEnginesWrites) {
  constexpr uint32_t kNumber = 21;
  auto engines = gpu::Buffer::create(
      recorder().device(),
      {.name = "engine's",
       .bytes = uint64_t{kSmall.width} * kSmall.height * sizeof(uint32_t),
       .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT});
  ASSERT_TRUE(engines.ok()) << engines.error().message;
  const auto result = system().run([&](VkCommandBuffer handle) {
    gpu::CommandList(handle, false).fill_buffer(engines->handle(), kNumber);
    Frame frame = context().record(handle);
    const BufferRef lent = frame.import({.buffer = engines->handle(),
                                         .bytes = engines->bytes(),
                                         .last_stage = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
                                         .last_access = VK_ACCESS_2_TRANSFER_WRITE_BIT});
    const Image shown = recorder().image("shown", kSmall, Format::r32ui);
    recorder().dispatch("test.show", {.shader = shaders::frame_test_shaders_show_comp,
                                      .read = {{"numbers", lent}},
                                      .write = {{"shown", shown}},
                                      .over = kSmall});
    recorder().read_back("shown", shown);
    return frame.finish();
  });
  ASSERT_TRUE(result.ok()) << result.error().message;
  expect_all("shown", static_cast<float>(kNumber));
}

// A technique's output goes into an engine's image that nobody has written yet.
TEST_F(RecorderTest, CopiesGoIntoImportedImages) {
  constexpr VkImageLayout kLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
  for (const Format format : {Format::rgba32f, Format::d32f}) {
    auto made = gpu::Texture::create(recorder().device(), {.name = "engine's",
                                                           .extent = kSmall,
                                                           .format = format,
                                                           .usage = gpu::general_usage(format)});
    ASSERT_TRUE(made.ok()) << made.error().message;
    const auto result = system().run([&](VkCommandBuffer handle) {
      const gpu::ImageTransition begin{
          made->handle(),
          made->aspect(),
          {VK_PIPELINE_STAGE_2_NONE, VK_ACCESS_2_NONE, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
           VK_ACCESS_2_NONE, VK_IMAGE_LAYOUT_UNDEFINED, kLayout}};
      gpu::CommandList(handle, false).barrier(std::span(&begin, 1), {});
      Frame frame = context().record(handle);
      const Image lent = frame.import({.image = made->handle(),
                                       .view = made->view(),
                                       .format = format,
                                       .extent = kSmall,
                                       .layout = kLayout,
                                       .last_stage = VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                                       .last_access = VK_ACCESS_2_SHADER_SAMPLED_READ_BIT});
      Image ours = constant("ours", kSmall, 0.75f);
      if (format == Format::d32f) {
        ours = recorder().image("ours", kSmall, format);
        recorder().draw("test.clear", {.state = {.vertex = &shaders::frame_test_shaders_fill_vert},
                                       .params = FillParams{vec4(0.0f), 0.0f},
                                       .depth = DrawTarget{"depth", ours, {0.75f}},
                                       .record = [](DrawList&) {}});
      }
      frame.copy(ours, lent);
      const Image seen = recorder().image("seen", kSmall, Format::rgba32f);
      copy("test.see", lent, seen);
      recorder().read_back("lent", lent);
      return frame.finish();
    });
    ASSERT_TRUE(result.ok()) << result.error().message;
    expect_all("lent", 0.75f);
    EXPECT_EQ(pixels("lent").channels, gpu::info(format).channels);
  }
}

TEST_F(RecorderTest, AnErrorStopsTheFrameAndOnlyThatFrame) {
  const Error error = failure([&](Frame&) {
    const Image good = constant("good", kSmall, 1.0f);
    const Image too_large = recorder().image("panorama", kTooLarge, Format::rgba32f);
    EXPECT_FALSE(too_large.valid());
    EXPECT_TRUE(recorder().failed());
    copy("test.after", good, too_large);
    EXPECT_FALSE(recorder().image("later", kSmall, Format::rgba32f).valid());
    EXPECT_TRUE(recorder().written_images().empty());
    recorder().image("second error", {200'000, 1}, Format::r8);
  });
  EXPECT_EQ(error.kind, ErrorKind::usage);
  EXPECT_NE(error.message.find("panorama"), std::string::npos) << error.message;
  EXPECT_NE(error.message.find("100000x1"), std::string::npos) << error.message;
  EXPECT_EQ(error.message.find('\n'), std::string::npos) << error.message;

  run([&](Frame&) {
    const Image to = recorder().image("to", kSmall, Format::rgba32f);
    copy("test.copy", constant("three", kSmall, 3.0f), to);
    recorder().read_back("to", to);
  });
  expect_all("to", 3.0f);
}

TEST_F(RecorderTest, EveryPassIsTimed) {
  run([&](Frame&) {
    const Image a = constant("a", {256, 256}, 1.0f);
    const Image b = recorder().image("b", {256, 256}, Format::rgba32f);
    copy("test.one", a, b);
    copy("test.two", b, a);
    recorder().draw("test.draw", {.state = {.vertex = &shaders::frame_test_shaders_fill_vert,
                                            .fragment = &shaders::frame_test_shaders_fill_frag},
                                  .params = FillParams{vec4(1.0f), 0.5f},
                                  .color = {{"color", b}},
                                  .record = [](DrawList& list) { list.fullscreen_triangle(); }});
  });
  const std::vector<PassTime> times = context().pass_times();
  ASSERT_EQ(times.size(), 3u);
  const char* const names[] = {"test.one", "test.two", "test.draw"};
  for (size_t i = 0; i < times.size(); ++i) {
    EXPECT_EQ(times[i].name, names[i]);
    EXPECT_GT(times[i].gpu_ms, 0.0) << names[i];
  }
}

// Passes of one owner have one timer from the first to where another's begin, or to the frame's
// end.
TEST_F(RecorderTest, AnOwnersPassesAreTimedTogether) {
  context().set_timers(Timers::together);
  run([&](Frame&) {
    const Image a = constant("a", {256, 256}, 1.0f);
    const Image b = recorder().image("b", {256, 256}, Format::rgba32f);
    for (const char* pass : {"first.one", "first.two", "second.view.one", "first.three"})
      copy(pass, a, b);
  });
  const std::vector<PassTime> times = context().pass_times();
  ASSERT_EQ(times.size(), 3u);
  const char* const names[] = {"first.*", "second.view.*", "first.*"};
  for (size_t i = 0; i < times.size(); ++i) {
    EXPECT_EQ(times[i].name, names[i]);
    EXPECT_GT(times[i].gpu_ms, 0.0) << names[i];
  }
  context().set_timers(Timers::off);
  run([&](Frame&) {
    copy("first.one", constant("a", kSmall, 1.0f), recorder().image("b", kSmall, Format::rgba32f));
  });
  EXPECT_TRUE(context().pass_times().empty());
}

}  // namespace
}  // namespace lueur
