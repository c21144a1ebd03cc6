// SPDX-License-Identifier: MIT
// Lists that passes append to and later passes go through, without the CPU. In shaders:
//   buffer List { uint count; Entry data[]; } list;
//   list.data[atomicAdd(list.count, 1u)] = …
#pragma once

#include <cstdint>
#include <string>

#include "frame/recorder.h"

namespace lueur {

// Room for so many entries of so many bytes, after a pass that empties it. Passes that append have
// to leave out what finds no room; `count` then is above the capacity.
BufferRef device_list(Recorder& frame, const std::string& pass, const char* name, uint32_t capacity,
                      uint32_t entry_bytes);
// Empties it again.
void clear_device_list(Recorder& frame, const std::string& pass, BufferRef list);

// For Dispatch::groups: as many workgroups as go through all entries. A workgroup's number is
// gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x; the last ones may find nothing.
BufferRef groups_of_list(Recorder& frame, const std::string& pass, BufferRef list,
                         uint32_t capacity, uint32_t entries_per_group);

}  // namespace lueur
