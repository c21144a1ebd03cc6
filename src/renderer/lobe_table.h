// SPDX-License-Identifier: MIT
// The cosine lobes of a scene's materials, as the renderer's shaders and techniques find them.
#pragma once

#include <span>
#include <vector>

#include "lueur/g_buffer.h"
#include "renderer/params.h"
#include "scene/scene.h"

namespace lueur {

struct LobeTable {
  std::vector<LobeData> lobes;        // each colour and shape once; kMostCosineLobes at most
  std::vector<CosineLobe> shapes;     // what Inputs::lobes is: each shape once
  std::vector<uint32_t> of_material;  // MaterialData::cosine_lobe
  size_t left_out = 0;                // materials whose lobe found no room: they have none
};

// Shapes beyond those that GBuffer::reflectance can name are named as GGX lobes of their width.
// Unlit materials have no lobe.
LobeTable lobe_table(std::span<const Material> materials);

}  // namespace lueur
