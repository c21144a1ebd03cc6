// SPDX-License-Identifier: MIT
// The makers of the built-in scenes, one source file each. Callers use builtin.h.
#pragma once

#include <cstdint>

#include "scene/scene.h"

namespace lueur::builtin {

// The measured Cornell box, ten times its size (5.5 m), so that it is a room.
Scene make_cornell();

// A two-storey colonnaded courtyard in the sun with coloured drapes. Draws `triangles` ± 10 %, for
// kMinAtriumTriangles … kMaxAtriumTriangles.
inline constexpr uint32_t kMinAtriumTriangles = 10'000;
inline constexpr uint32_t kMaxAtriumTriangles = 1'000'000;
inline constexpr uint32_t kDefaultAtriumTriangles = 100'000;
Scene make_atrium(uint32_t triangles);

// A row of coloured dominoes that topples over a polished floor; few, large triangles.
Scene make_dominoes();

// A graveyard by moon and lantern: about 120 000 triangles of small relief.
Scene make_graveyard();

// A spotlight turned at the floor between objects that only the floor's light reaches.
Scene make_spot_floor();

// A basket whose lit side only the camera `side` sees; it lights the wall behind.
Scene make_basket();

// A cubic room with a divider, through which a detailed object of 60 000 triangles moves.
Scene make_divider_room();

// A detailed object that floats and turns in a box under a spotlight; it has 69 000 triangles.
Scene make_floating_object();

// A laid table in a room lit by one patch of sun on the wall.
Scene make_table();

// Glossy and diffuse things on a cloth, with a hollow skull, and letters that the camera does not
// see: about 200 000 triangles.
Scene make_still_life();

// A hall with a sun, a spotlight and a bulb, on walls of different colours.
Scene make_three_lights();

}  // namespace lueur::builtin
