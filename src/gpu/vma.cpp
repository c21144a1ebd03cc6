// SPDX-License-Identifier: MIT
// The body of the Vulkan Memory Allocator, in a file of its own: it takes long to compile and has
// warnings that are not ours.
#include "gpu/vulkan.h"

#define VMA_STATIC_VULKAN_FUNCTIONS 0
#define VMA_DYNAMIC_VULKAN_FUNCTIONS 1
#define VMA_IMPLEMENTATION
#include <vk_mem_alloc.h>
