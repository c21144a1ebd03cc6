// SPDX-License-Identifier: MIT
// Settings of `hierarchical` that go together.
#pragma once

#include <span>

#include "lueur/technique.h"

namespace lueur {

std::span<const Preset> hierarchical_presets();

}  // namespace lueur
