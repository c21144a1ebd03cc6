// SPDX-License-Identifier: MIT
// The filter of techniques that gather in slices: hbao and visibility_bitmask.
#pragma once

#include <cstdint>

namespace lueur {

// Over how many pixels a side it averages, of one surface. Nine pixels of 3 x 3 have interleaved
// samples, and so have nine such blocks.
enum class SliceFilter : int32_t { none, three, nine };

}  // namespace lueur
