// SPDX-License-Identifier: MIT
// Reads Wavefront OBJ files, with the MTL files and textures beside them, into a Scene. The files
// may come from anyone: every number, index, count and path in them is checked before it is used.
//
// Read: polygons of any shape, cut into triangles; normals, texture coordinates, smoothing groups;
// objects and groups, each name one mesh on one node; materials as mtl_load.h tells. Where a
// polygon has no normals, its smoothing group gives them, and without one it is flat. Materials are
// double-sided: the format knows no backs. Lengths are taken as metres, +y as up.
//
// Left out with a line in Scene::warnings: points, lines, curves and surfaces, vertex colours, MTL
// files and textures that are missing or lie outside the folder of the asset.
//
// The parser is our own. tinyobjloader, which Debian packages, takes malformed numbers for 0,
// negative indices beyond the first vertex as they are, gives no line numbers for most faults, and
// takes memory for whatever a file asks.
#pragma once

#include <filesystem>

#include "lueur/result.h"
#include "scene/load_limits.h"
#include "scene/scene.h"

namespace lueur {

// Fails with ErrorKind::input and a line that names the file, the line number and the remedy. The
// scene has no camera and no light but what its materials emit; see scene/framing.h.
Result<Scene> load_obj(const std::filesystem::path& path, const LoadLimits& limits = {});

}  // namespace lueur
