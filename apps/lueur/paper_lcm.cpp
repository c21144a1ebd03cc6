// SPDX-License-Identifier: MIT
// LCM figures 6 to 8: an object in a room with a divider, lit by maps of few texels.
#include <algorithm>
#include <string>

#include "base/try.h"
#include "paper_parts.h"
#include "picture.h"
#include "reference_trace.h"

namespace lueur::cli::lcm {
namespace {

constexpr char kScene[] = "divider-room";

// Where the object is at these times, and a camera that sees it there.
struct Place {
  const char* name;
  float time_s;
  const char* camera;
};
constexpr Place kPlaces[] = {{"the room's centre", 0.0f, "room"},
                             {"near a wall", 1.15f, "left"},
                             {"in a corner", 2.10f, "left"},
                             {"behind the divider", 5.0f, "behind"}};

struct Method {
  const char* name;
  std::vector<std::string> settings;
  bool is_shown;
};

std::vector<Method> methods() {
  std::vector<Method> all = {{"classical", {"method=classical", "side=32"}, true}};
  for (const char* side : {"2", "4", "8", "16", "64"})
    all.push_back({side, {std::string("side=") + side}, std::string(side).size() == 1});
  all.push_back({"full", {"side=256"}, true});
  return all;
}

// What a figure looks at.
struct Subject {
  const char* image;  // of the renderer
  const char* layer;  // of the reference
  std::vector<std::string> settings;
  float brighter_ev;
};

// The light of all methods at one place, in the object's pixels.
struct Lit {
  std::vector<ImageF> by_method;
  Mask object;
};

Mask mask_of_object(const Pixels& indirect) {
  Mask mask{indirect.extent.width, indirect.extent.height, {}};
  for (size_t i = 3; i < indirect.samples.size(); i += 4)
    mask.counts.push_back(indirect.samples[i] > 0.0f ? 1 : 0);
  return mask;
}

// Black where the mask says no.
ImageF masked(ImageF light, const Mask& mask) {
  for (size_t i = 0; i < light.samples.size(); ++i)
    if (!counts(&mask, i / light.channels)) light.samples[i] = 0.0f;
  return light;
}

// The object and a little around it.
struct Window {
  uint32_t left, top, width, height;
};

Window window_of(const Mask& mask) {
  uint32_t left = mask.width, right = 0, top = mask.height, bottom = 0;
  for (uint32_t i = 0; i < mask.counts.size(); ++i) {
    if (!counts(&mask, i)) continue;
    left = std::min(left, i % mask.width), right = std::max(right, i % mask.width + 1);
    top = std::min(top, i / mask.width), bottom = std::max(bottom, i / mask.width + 1);
  }
  if (left >= right) return {0, 0, mask.width, mask.height};
  const uint32_t margin = std::max(mask.width / 64, 1u);
  left -= std::min(left, margin), top -= std::min(top, margin);
  right = std::min(right + margin, mask.width), bottom = std::min(bottom + margin, mask.height);
  return {left, top, right - left, bottom - top};
}

ImageF cut_out(const ImageF& image, const Window& window) {
  ImageF part(window.width, window.height, image.channels);
  for (uint32_t y = 0; y < window.height; ++y)
    std::copy_n(
        &image.samples[(size_t{window.top + y} * image.width + window.left) * image.channels],
        window.width * image.channels, &part.samples[size_t{y} * window.width * image.channels]);
  return part;
}

Result<Lit> light_of(Session& session, std::vector<Candidate>& candidates, const Scene& scene,
                     const Subject& subject, const Place& place) {
  LUEUR_TRY(camera, find_camera(scene, place.camera));
  Lit lit;
  for (Candidate& candidate : candidates) {
    candidate.shot.camera = camera;
    candidate.shot.time_s = candidate.shot.previous_time_s = place.time_s;
    LUEUR_TRY(frame, render_candidate(session, candidate, {"indirect", subject.image}));
    lit.object = mask_of_object(*find_pixels(frame.pixels, "indirect"));
    lit.by_method.push_back(
        masked(as_image(*find_pixels(frame.pixels, subject.image), 3), lit.object));
  }
  return lit;
}

Result<ImageF> truth_of(const Scene& scene, const Subject& subject, const Place& place,
                        const PaperSetup& setup, Extent size) {
  LUEUR_TRY(camera, find_camera(scene, place.camera));
  LUEUR_TRY(truth, trace_reference(scene, {size.width, size.height, camera, place.time_s},
                                   {.mode = reference::Mode::path, .spp = setup.spp}, place.name,
                                   setup.stop, setup.cache));
  return *find_layer(truth.rendering, subject.layer);
}

report::Table empty_table(const std::string& caption, size_t method_count) {
  report::Table table{caption, {}, {}};
  table.columns = {{"object", "", "", 3}};
  const std::vector<Method> all = methods();
  for (size_t i = 0; i < method_count; ++i) {
    const bool is_side = i > 0 && i + 1 < all.size();
    table.columns.push_back({all[i].name, "%", is_side ? "M" : "", 3});
  }
  return table;
}

Result<report::FigureSection> figure(Session& session, const PaperSetup& setup, const Scene& scene,
                                     const Subject& subject) {
  const Extent size = setup.picture_size;
  const float exposure_ev = scene.exposure_ev.value_or(0.0f) + subject.brighter_ev;
  std::vector<ImageF> truths;
  for (const Place& place : kPlaces) {
    LUEUR_TRY(truth, truth_of(scene, subject, place, setup, size));
    if (setup.stop.stop_requested()) return report::FigureSection{};
    truths.push_back(std::move(truth));
  }
  report::FigureSection section;
  for (const char* centre : {"scene", "object"}) {
    const bool is_papers = std::string_view(centre) == "scene";
    std::vector<std::vector<std::string>> settings;
    for (const Method& method : methods()) {
      std::vector<std::string> one = {"probes=0", "faces_a_frame=600",
                                      std::string("centre=") + centre};
      one.insert(one.end(), method.settings.begin(), method.settings.end());
      one.insert(one.end(), subject.settings.begin(), subject.settings.end());
      settings.push_back(std::move(one));
    }
    LUEUR_TRY(candidates, candidates_on(session, scene, kScene, setup, size, "cube_map", settings));
    const size_t full = candidates.size() - 1;
    const std::string where = is_papers ? "one map in the middle of the room, as in the paper"
                                        : "a map in the middle of the object";
    report::Table to_full = empty_table("Off the sum over 6 x 256 x 256 texels: " + where, full);
    report::Table to_truth = empty_table("Off path-traced light: " + where, full + 1);
    for (size_t p = 0; p < std::size(kPlaces); ++p) {
      LUEUR_TRY(lit, light_of(session, candidates, scene, subject, kPlaces[p]));
      const ImageF truth = masked(truths[p], lit.object);
      const Window window = window_of(lit.object);
      std::vector<report::Cell> off_full = {kPlaces[p].name}, off_truth = {kPlaces[p].name};
      report::PictureRow row{{}, std::string(kPlaces[p].name) + ": " + where};
      const std::vector<Method> all = methods();
      for (size_t i = 0; i <= full; ++i) {
        const ImageF& light = lit.by_method[i];
        if (i < full)
          off_full.emplace_back(100.0 *
                                relative_difference(light, lit.by_method[full], &lit.object));
        off_truth.emplace_back(100.0 * relative_difference(light, truth, &lit.object));
        const bool is_side = i > 0 && i < full;
        if (all[i].is_shown)
          row.pictures.push_back({shown(cut_out(light, window), exposure_ev),
                                  is_side ? std::string("M = ") + all[i].name : all[i].name,
                                  {}});
      }
      row.pictures.push_back({shown(cut_out(truth, window), exposure_ev), "Path traced", {}});
      to_full.rows.push_back(std::move(off_full));
      to_truth.rows.push_back(std::move(off_truth));
      if (is_papers) section.blocks.emplace_back(std::move(row));
      if (setup.stop.stop_requested()) return section;
    }
    section.blocks.emplace_back(std::move(to_full));
    section.blocks.emplace_back(std::move(to_truth));
  }
  section.blocks.emplace_back(report::Paragraph{
      "Root mean square of the difference over that of what it is held against, of the light in "
      "the object's pixels. Maps leave the object itself out, path-traced light does not: it has "
      "the object's own shadows and reflections. The paper has pictures alone."});
  return section;
}

}  // namespace

Result<report::FigureSection> diffuse(Session& session, const PaperSetup& setup) {
  LUEUR_TRY(loaded, load_scene(kScene));
  return figure(session, setup, loaded.scene, {"indirect", "indirect", {}, 2.0f});
}

Result<report::FigureSection> glossy(Session& session, const PaperSetup& setup) {
  LUEUR_TRY(loaded, load_scene(kScene));
  const auto object = std::find_if(loaded.scene.materials.begin(), loaded.scene.materials.end(),
                                   [](const Material& m) { return m.name == "porcelain"; });
  object->phong = PhongLobe{.color = glm::vec3(0.9f), .exponent = 5.0f};
  return figure(session, setup, loaded.scene,
                {"indirect_specular", "indirect_specular", {"glossy=true"}, 2.0f});
}

}  // namespace lueur::cli::lcm
