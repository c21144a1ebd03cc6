// SPDX-License-Identifier: MIT
// The one place where Vulkan's functions come from: volk's table, loaded at run time.
#pragma once

#ifndef VK_NO_PROTOTYPES
#define VK_NO_PROTOTYPES
#endif
#include <volk.h>
