// SPDX-License-Identifier: MIT
// For tests that render with the program's parts: a session on any device, checked by Vulkan's
// validation, and a technique that tells what it remembers.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <utility>
#include <vector>

#include "session.h"

namespace lueur::cli {

// Writes an image that it wants back in the next frame, and notes whether it came.
class Remembering final : public Technique {
 public:
  Outputs render(Frame& frame, const Inputs& inputs) override {
    Recorder& recorder = frame.recorder();
    const Extent extent = inputs.g_buffer.depth.extent;
    const HistoryImage h = recorder.history("remembered", extent, Format::rgba16f);
    const std::vector<uint16_t> halves(size_t{extent.width} * extent.height * 4);
    recorder.copy(recorder.upload_image("new", extent, Format::rgba16f, halves.data()), h.current);
    remembered.push_back(h.valid);
    return {};
  }
  void* settings() override { return nullptr; }
  std::vector<bool> remembered;
};

class SessionTest : public testing::Test {
 protected:
  void SetUp() override {
    auto system = gpu::System::create({.validation = true});
    ASSERT_TRUE(system.ok()) << system.error().message;
    ContextInfo info = (*system)->context_info();
    info.frames_in_flight = 1;
    info.timers = Timers::passes;
    auto context = Context::create(info);
    ASSERT_TRUE(context.ok()) << context.error().message;
    session_.emplace(Session{std::move(*system), std::move(*context)});
  }
  void TearDown() override {
    if (!session_) return;
    for (const std::string& message : session_->system->validation_messages())
      ADD_FAILURE() << "validation: " << message;
  }

  std::optional<Session> session_;
};

}  // namespace lueur::cli
