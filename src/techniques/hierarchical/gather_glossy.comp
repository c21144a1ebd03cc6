// SPDX-License-Identifier: MIT
// Glossy light, as if nothing stood between any two points.
#version 460
#extension GL_EXT_scalar_block_layout : require

#include "shading/form_factor.h"
#include "techniques/hierarchical/equations.h"
#include "techniques/hierarchical/params.h"

const uint march_rays = 0;

#include "techniques/hierarchical/gather_glossy.glsl"

float visibility(vec2 at_px, float z, ivec2 q, float z_of_patch) { return 1.0; }
