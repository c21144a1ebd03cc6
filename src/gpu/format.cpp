// SPDX-License-Identifier: MIT
#include "gpu/format.h"

#include "base/check.h"

namespace lueur::gpu {
namespace {

constexpr FormatInfo kFormats[] = {
    {Format::r8, VK_FORMAT_R8_UNORM, "r8", "r8", 1, 1, false, false},
    {Format::rg8, VK_FORMAT_R8G8_UNORM, "rg8", "rg8", 2, 2, false, false},
    {Format::rgba8, VK_FORMAT_R8G8B8A8_UNORM, "rgba8", "rgba8", 4, 4, false, false},
    {Format::rgba8_srgb, VK_FORMAT_R8G8B8A8_SRGB, "rgba8_srgb", "", 4, 4, false, false},
    {Format::rg16_snorm, VK_FORMAT_R16G16_SNORM, "rg16_snorm", "rg16_snorm", 4, 2, false, false},
    {Format::r16f, VK_FORMAT_R16_SFLOAT, "r16f", "r16f", 2, 1, true, false},
    {Format::rg16f, VK_FORMAT_R16G16_SFLOAT, "rg16f", "rg16f", 4, 2, true, false},
    {Format::rgba16f, VK_FORMAT_R16G16B16A16_SFLOAT, "rgba16f", "rgba16f", 8, 4, true, false},
    {Format::r32f, VK_FORMAT_R32_SFLOAT, "r32f", "r32f", 4, 1, true, false},
    {Format::rgba32f, VK_FORMAT_R32G32B32A32_SFLOAT, "rgba32f", "rgba32f", 16, 4, true, false},
    {Format::r32ui, VK_FORMAT_R32_UINT, "r32ui", "r32ui", 4, 1, false, false},
    {Format::rgba32ui, VK_FORMAT_R32G32B32A32_UINT, "rgba32ui", "rgba32ui", 16, 4, false, false},
    {Format::d32f, VK_FORMAT_D32_SFLOAT, "d32f", "", 4, 1, true, true},
};

}  // namespace

const FormatInfo& info(Format format) {
  const FormatInfo& row = kFormats[static_cast<size_t>(format)];
  LUEUR_CHECK(row.format == format);
  return row;
}

}  // namespace lueur::gpu
