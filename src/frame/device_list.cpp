// SPDX-License-Identifier: MIT
#include "frame/device_list.h"

#include "frame/shaders.h"

namespace lueur {

BufferRef device_list(Recorder& frame, const std::string& pass, const char* name, uint32_t capacity,
                      uint32_t entry_bytes) {
  const BufferRef list = frame.buffer(name, sizeof(uint32_t) + uint64_t{capacity} * entry_bytes);
  clear_device_list(frame, pass, list);
  return list;
}

void clear_device_list(Recorder& frame, const std::string& pass, BufferRef list) {
  frame.dispatch(
      pass, {.shader = shaders::frame_list_begin_comp, .write = {{"list", list}}, .over = {1, 1}});
}

BufferRef groups_of_list(Recorder& frame, const std::string& pass, BufferRef list,
                         uint32_t capacity, uint32_t entries_per_group) {
  const BufferRef groups = frame.buffer("groups", 3 * sizeof(uint32_t));
  frame.dispatch(pass,
                 {.shader = shaders::frame_list_end_comp,
                  .constants = {{"entries_per_group", entries_per_group}, {"capacity", capacity}},
                  .read = {{"list", list}},
                  .write = {{"groups", groups}},
                  .over = {1, 1}});
  return groups;
}

}  // namespace lueur
