// SPDX-License-Identifier: MIT
// What belongs to one of the frames in flight, and is used again when that frame is done.
#pragma once

#include "frame/recorder.h"

namespace lueur {

struct Recorder::Slot {
  explicit Slot(gpu::Device& device) : descriptors(device), timers(device) {}

  gpu::DescriptorArena descriptors;

  // Uploads, appended to mapped chunks.
  struct Chunk {
    gpu::Buffer buffer;
    uint64_t used = 0;
  };
  std::vector<Chunk> chunks;

  gpu::TimerPool timers;
  Timers timing = Timers::off;
  std::vector<std::pair<std::string, uint32_t>> timed_passes;  // name, its first query

  std::vector<ReadBack> read_backs;

  // Scan results: one row an image, counted on the device and copied for the CPU.
  gpu::Buffer scan_rows;
  gpu::Buffer scan_copy;
  gpu::AccessState scan_state;
  std::vector<std::pair<std::string, Extent>> scanned;
};

}  // namespace lueur
