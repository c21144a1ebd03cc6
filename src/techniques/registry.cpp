// SPDX-License-Identifier: MIT
// The list of techniques: one line each.
#include "lueur/cube_map.h"
#include "lueur/hbao.h"
#include "lueur/hierarchical.h"
#include "lueur/indirect_lights.h"
#include "lueur/visibility_bitmask.h"
#include "techniques/hierarchical/presets.h"

namespace lueur {
namespace {

template <class T>
std::unique_ptr<Technique> make() {
  return std::make_unique<T>();
}

const TechniqueInfo kTechniques[] = {
    {"hierarchical", "Rings of samples in a pyramid of the camera's own G-buffer.",
     "Soler, Hoel, Rochet, Holzschuch 2009, INRIA RR-7162", "off_screen",
     Hierarchical::settings_table(), make<Hierarchical>, hierarchical_presets()},
    {"indirect_lights", "Patches that the lights shine on as lights, and negative ones.",
     "Cochran, Steele 2007, ACMSE", "gathered", IndirectLights::settings_table(),
     make<IndirectLights>},
    {"cube_map", "Localized cube maps around moving objects, and probes for what stands still.",
     "Szirmay-Kalos, Lazányi 2006, SCCG", "own_map", CubeMap::settings_table(), make<CubeMap>},
    {"visibility_bitmask",
     "Slices of the camera's own G-buffer with a bit mask of what is covered.",
     "Therrien, Levesque, Gilet 2023, The Visual Computer", "", VisibilityBitmask::settings_table(),
     make<VisibilityBitmask>},
    {"hbao", "Ambient occlusion alone, by the horizons around a pixel.",
     "Bavoil, Sainz, Dimitrov 2008, SIGGRAPH Talks", "", Hbao::settings_table(), make<Hbao>},
};

}  // namespace

std::span<const TechniqueInfo> techniques() {
  return kTechniques;
}

const TechniqueInfo* find_technique(std::string_view name) {
  for (const TechniqueInfo& info : kTechniques)
    if (info.name == name) return &info;
  return nullptr;
}

}  // namespace lueur
