// SPDX-License-Identifier: MIT
// The public face of the recorder.
#include "lueur/context.h"

#include "base/try.h"
#include "frame/recorder.h"

namespace lueur {

Image Frame::import(const ExternalImage& image) {
  return recorder_->import(image);
}
BufferRef Frame::import(const ExternalBuffer& buffer) {
  return recorder_->import(buffer);
}
void Frame::copy(Image from, Image to) {
  recorder_->copy(from, to);
}
Result<void> Frame::finish() {
  return recorder_->finish();
}

Context::Context() = default;
Context::Context(Context&&) noexcept = default;
Context& Context::operator=(Context&&) noexcept = default;
Context::~Context() = default;

Result<Context> Context::create(const ContextInfo& info) {
  LUEUR_TRY(recorder, Recorder::create(info));
  Context context;
  context.recorder_ = std::move(recorder);
  return context;
}

Frame Context::record(VkCommandBuffer command_buffer) {
  recorder_->begin(command_buffer);
  return Frame(recorder_.get());
}

void Context::set_timers(Timers timers) {
  recorder_->set_timers(timers);
}
std::vector<PassTime> Context::pass_times() {
  return recorder_->pass_times();
}
MemoryUse Context::memory() const {
  return recorder_->memory();
}

}  // namespace lueur
