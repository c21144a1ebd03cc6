// SPDX-License-Identifier: MIT
// FDP figure 3: where samples lie, and a glossy floor without and with importance sampling.
#include <algorithm>
#include <string>

#include "base/try.h"
#include "paper_fdp_samples.h"
#include "paper_parts.h"
#include "picture.h"

namespace lueur::cli::fdp {
namespace {

constexpr char kScene[] = "dominoes";
constexpr float kFloorMetallic = 0.8f;
constexpr uint32_t kSamples = 64, kManySamples = 256, kSeeds = 6;

// The paper's lobe. As a metal the floor has little diffuse light, and is found by it.
void make_glossy(Material& floor) {
  floor.phong = PhongLobe{.color = glm::vec3(0.4f), .exponent = 128.0f};
  floor.metallic = kFloorMetallic;
}

// The floor is the only metal.
Mask floor_of(const ImageF& material) {
  Mask mask{material.width, material.height, {}};
  for (size_t i = 0; i < material.samples.size(); i += material.channels)
    mask.counts.push_back(material.samples[i] > 0.5f * kFloorMetallic ? 1 : 0);
  return mask;
}

std::vector<std::string> glossy_settings(uint32_t samples, bool importance) {
  return paper_settings({"start=half", "levels=4", "temporal=0", "glossy=true",
                         "glossy_samples=" + std::to_string(samples),
                         std::string("glossy_importance=") + (importance ? "true" : "false")});
}

report::PictureRow placement(const PaperSetup& setup) {
  HierarchicalSettings settings;
  settings.radius = 40.0f;
  settings.levels = 4;
  settings.sample_growth = 1;
  return {{{draw_samples(settings, 0, setup.seed), "Samples of a pixel, level 1", {}},
           {draw_samples(settings, 1, setup.seed), "Samples of a pixel, all further levels", {}},
           {draw_participants(settings, setup.picture_size, setup.seed),
            "Participating pixels of the central (red) one",
            {}}},
          "Left: 64 samples, r = 40 and r / 2. Right: what the central pixel's light comes from "
          "after filters and up-sampling, half start; dark: no sample, the brighter the finer the "
          "level. Drawn by the technique's formulas, as on one smooth surface."};
}

}  // namespace

Result<report::FigureSection> glossy(Session& session, const PaperSetup& setup) {
  LUEUR_TRY(loaded, load_scene(kScene));
  Scene& scene = loaded.scene;
  const auto floor = std::find_if(scene.materials.begin(), scene.materials.end(),
                                  [](const Material& m) { return m.name == "polished floor"; });
  make_glossy(*floor);
  LUEUR_TRY(candidates,
            candidates_on(session, scene, kScene, setup, setup.picture_size, "hierarchical",
                          {glossy_settings(kSamples, false), glossy_settings(kSamples, true),
                           glossy_settings(kManySamples, true)}));
  const float exposure_ev = scene.exposure_ev.value_or(0.0f);
  LUEUR_TRY(first, render_candidate(session, candidates[2], {"material"}));
  const Mask on_floor = floor_of(as_image(*find_pixels(first.pixels, "material"), 3));
  const auto render = [&](size_t candidate) {
    return render_seeds(session, candidates[candidate], "indirect_specular", kSeeds, &on_floor);
  };
  LUEUR_TRY(truth, render(2));

  report::PictureRow pictures{
      {},
      "dominoes with a floor of Phong's exponent 128, 64 glossy samples a level, one "
      "frame. Above with direct and diffuse indirect light, then the light through glossy lobes "
      "alone, two stops brighter."};
  report::PictureRow alone;
  report::Table table{"Light through glossy lobes on the floor, off the mean of " +
                          std::to_string(kSeeds) + " frames of 256 samples, importance sampled",
                      {},
                      {}};
  table.columns = {{"", "", "", 3},
                   {"noise", "of the mean", "", 3},
                   {"off by", "relative", "one frame", 3},
                   {"off by", "relative", std::to_string(kSeeds) + " frames", 3}};
  for (size_t i = 0; i < 2; ++i) {
    const std::string name = i == 0 ? "no importance sampling" : "importance sampling";
    LUEUR_TRY(seeds, render(i));
    LUEUR_TRY(frame, render_candidate(session, candidates[i], {"composed"}));
    const ImageF composed = as_image(*find_pixels(frame.pixels, "composed"), 3);
    table.rows.push_back({name, seeds.noise,
                          relative_difference(seeds.first, truth.mean, &on_floor),
                          relative_difference(seeds.mean, truth.mean, &on_floor)});
    pictures.pictures.push_back({shown(composed, exposure_ev), "Picture, " + name, {}});
    alone.pictures.push_back({shown(seeds.first, exposure_ev, 2.0f), "Glossy light, " + name, {}});
  }
  alone.pictures.push_back(
      {shown(truth.mean, exposure_ev, 2.0f), "Glossy light, mean of many samples", {}});
  report::FigureSection section;
  section.blocks = {
      placement(setup), pictures, alone, table,
      report::Paragraph{
          "The paper has no numbers for noise: its pictures show "
          "a grainy floor without and a clean one with importance sampling. “Off by” is the root "
          "mean square of the difference over that of the mean of many."}};
  return section;
}

}  // namespace lueur::cli::fdp
