// SPDX-License-Identifier: MIT
// What an MTL material is in a Scene.
//
//   Kd, map_Kd        albedo; 0.8 where neither is told
//   Ks, Ns            a Phong lobe (Material::phong), left out by illum 0 and 1
//   Pr, Pm, map_Pr, map_Pm   in place of Ks and Ns: glTF's metallic-roughness model
//   Ke, map_Ke        emitted radiance in cd/m2
//   d, Tr, map_d      below 0.5: cut out
//   norm, map_Bump    normal map; greys are heights, see obj_texture.h
//   -s, -o, -clamp, -bm, -imfchan   of a map; -s and -o of a material's first map hold for all
//
// All else is left out with a line in the warnings, but for what would not show.
#pragma once

#include "scene/mtl_read.h"
#include "scene/obj_texture.h"

namespace lueur {

struct ObjMaterial {
  Material material;
  UvTransform uv;
};

// Drawn where there is no material.
ObjMaterial default_obj_material();

// Fails on emission that is negative or beyond 1e9 cd/m2, and where ObjTextures does.
Result<ObjMaterial> make_obj_material(const MtlMaterial& from, ObjTextures& textures,
                                      Warnings& warnings);

}  // namespace lueur
