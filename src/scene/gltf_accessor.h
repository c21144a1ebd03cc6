// SPDX-License-Identifier: MIT
// Typed arrays of a glTF file, checked against their buffer views before a byte is read.
#pragma once

#include <cstdint>
#include <vector>

#include "lueur/result.h"
#include "scene/gltf_file.h"

namespace lueur {

struct AccessorShape {
  uint64_t count = 0;
  uint32_t components = 0;  // 1 to 4, and 16 for MAT4; other matrices are refused
  // False: all zeros (neither a buffer view nor sparse values), or the file gives no bytes for it.
  bool has_data = false;
};

// What accessor `index`, which must exist, claims to hold; its data are not looked at yet.
Result<AccessorShape> accessor_shape(const GltfFile& file, int32_t index);

// All values, count * components of them; normalized integers become [0, 1] or [-1, 1]. Values may
// be infinite or NaN: only the caller can name what they mean.
Result<std::vector<float>> read_floats(const GltfFile& file, int32_t index);

// All values of a scalar accessor of unsigned integers.
Result<std::vector<uint32_t>> read_unsigned(const GltfFile& file, int32_t index);

}  // namespace lueur
