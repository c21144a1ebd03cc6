// SPDX-License-Identifier: MIT
// HSSIL figure 5: equation (3) and equation (4) on a G-buffer that was traced, beside the truth.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/try.h"
#include "image/exposure.h"
#include "image/picture_error.h"
#include "image/tone_map.h"
#include "paper.h"
#include "picture.h"
#include "reference_trace.h"
#include "shading/packing.h"
#include "technique_list.h"

namespace lueur::cli::hssil {
namespace {

// The row of the slice, as a share of the height: from wall to wall over the floor and the foot of
// both blocks, where surfaces meet.
constexpr double kSliceRow = 0.79;

Result<reference::Rendering> trace(const Scene& scene, const PaperSetup& setup, uint32_t side,
                                   reference::Mode mode) {
  reference::Settings settings{.mode = mode, .bounces = 1, .spp = setup.spp, .seed = setup.seed};
  // All pixels: a share of them would show the spikes of the few that lie close to a receiver.
  if (mode == reference::Mode::screen_unoccluded) settings.spp = 0;
  LUEUR_TRY(traced,
            trace_reference(scene, {side, side, 0, 0.0f}, settings,
                            std::string(reference::name_of(mode)), setup.stop, setup.cache));
  return std::move(traced.rendering);
}

// The traced depth, normals and direct light as a host would hand them over.
GBuffer upload(Recorder& recorder, const reference::Rendering& traced, float near_m) {
  const ImageF &depth = *find_layer(traced, "depth"), &normal = *find_layer(traced, "normal"),
               &source = *find_layer(traced, "source");
  const Extent extent{depth.width, depth.height};
  std::vector<float> reversed;
  std::vector<glm::vec4> packed_normal, packed_source;
  for (size_t i = 0; i < depth.samples.size(); ++i) {
    const float z_m = depth.samples[i];
    const float *n = &normal.samples[3 * i], *s = &source.samples[3 * i];
    reversed.push_back(z_m > 0.0f ? near_m / z_m : 0.0f);
    const glm::vec2 octahedral =
        z_m > 0.0f ? octahedral_encode({n[0], n[1], n[2]}) : glm::vec2(0.0f);
    packed_normal.emplace_back(octahedral, 0.0f, 0.0f);
    packed_source.emplace_back(s[0], s[1], s[2], 1.0f);
  }
  return {recorder.upload_image("depth", extent, Format::r32f, reversed.data()),
          recorder.upload_image("normal", extent, Format::rgba32f, packed_normal.data()),
          recorder.upload_image("source", extent, Format::rgba32f, packed_source.data())};
}

// E/pi by the technique with this form factor, on the traced G-buffer.
Result<ImageF> gather(Session& session, const Scene& scene, const reference::Rendering& traced,
                      const char* form_factor, const PaperSetup& setup) {
  // r = 40 in the paper's rings from r to 2 r, four levels of 64 samples, no filter over time.
  LUEUR_TRY(chosen,
            choose_technique("hierarchical", {"start=full", "levels=4", "samples=64",
                                              "sample_growth=1", "radius=80", "filter=false",
                                              std::string("form_factor=") + form_factor}));
  const ImageF& depth = *find_layer(traced, "depth");
  const Shot shot{.extent = {depth.width, depth.height}};
  Recorder& recorder = session.context.recorder();
  recorder.forget_history();
  LUEUR_TRY_VOID(session.system->run([&](VkCommandBuffer commands) -> Result<void> {
    Frame frame = session.context.record(commands);
    const Inputs inputs{.view = view_of(scene, shot),
                        .g_buffer = upload(recorder, traced, scene.cameras[0].near_m),
                        .seed = setup.seed};
    recorder.read_back("indirect", chosen.technique->render(frame, inputs).diffuse);
    return frame.finish();
  }));
  const std::vector<Pixels> pixels = recorder.read_back_pixels();
  return as_image(*find_pixels(pixels, "indirect"), 3);
}

struct Method {
  std::string name;
  const ImageF* light;
  bool is_truth;
};

uint32_t slice_row(const ImageF& image) {
  return static_cast<uint32_t>(kSliceRow * image.height);
}

report::Curve slice(const Method& method) {
  report::Curve curve{method.name, {}, method.is_truth};
  const ImageF& light = *method.light;
  const uint32_t y = slice_row(light);
  for (uint32_t x = 0; x < light.width; ++x)
    curve.points.emplace_back(x, luminance_at(light, size_t{y} * light.width + x));
  return curve;
}

// How rough a slice is: the root mean square of its second difference over its mean. Spikes show,
// and slopes do not.
double roughness(const report::Curve& curve) {
  double sum = 0.0, mean = 0.0;
  for (size_t i = 1; i + 1 < curve.points.size(); ++i) {
    const double second =
        curve.points[i - 1].second - 2.0 * curve.points[i].second + curve.points[i + 1].second;
    sum += second * second;
    mean += curve.points[i].second;
  }
  const auto n = static_cast<double>(curve.points.size() - 2);
  return mean > 0.0 ? std::sqrt(sum / n) / (mean / n) : 0.0;
}

double largest(const report::Curve& curve) {
  double most = 0.0;
  for (const auto& [x, y] : curve.points) most = std::max(most, y);
  return most;
}

// RMSE over the reference's mean.
Result<double> relative_rmse(const ImageF& test, const ImageF& reference, const Mask& surfaces) {
  LUEUR_TRY(errors, scene_errors(test, reference, &surfaces));
  double mean = 0.0;
  for (size_t i = 0; i < surfaces.counts.size(); ++i)
    if (counts(&surfaces, i))
      for (size_t c = 0; c < 3; ++c)
        mean += static_cast<double>(reference.samples[3 * i + c]) / 3.0;
  return errors.rmse / (mean / static_cast<double>(surfaces.pixel_count()));
}

// The methods in the order of the figure, and those of them that others are held against.
using Methods = std::array<Method, 5>;
constexpr size_t kPath = 2, kScreen = 3, kAllPixels = 4;

Result<report::Table> error_table(const Methods& methods, const Mask& surfaces) {
  report::Table table{"How far each is off", {}, {}};
  table.columns = {{"", "", "", 3},
                   {"roughness", "", "slice", 3},
                   {"largest / truth's", "", "slice", 3},
                   {"all pixels", "", "relative RMSE against", 3},
                   {"what the camera sees", "", "relative RMSE against", 3},
                   {"path traced", "", "relative RMSE against", 3}};
  const double truth_largest = largest(slice(methods[kPath]));
  for (const Method& method : methods) {
    const report::Curve curve = slice(method);
    std::vector<report::Cell> row = {method.name, roughness(curve),
                                     truth_largest > 0.0 ? largest(curve) / truth_largest : 0.0};
    for (const size_t reference : {kAllPixels, kScreen, kPath}) {
      LUEUR_TRY(error, relative_rmse(*method.light, *methods[reference].light, surfaces));
      row.emplace_back(error);
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

Result<report::FigureSection> form_factors(Session& session, const PaperSetup& setup) {
  LUEUR_TRY(loaded, load_scene("cornell"));
  const Scene& scene = loaded.scene;
  const uint32_t side = setup.picture_size.height;
  LUEUR_TRY(path, trace(scene, setup, side, reference::Mode::path));
  LUEUR_TRY(screen, trace(scene, setup, side, reference::Mode::screen));
  LUEUR_TRY(sum, trace(scene, setup, side, reference::Mode::screen_unoccluded));
  if (setup.stop.stop_requested()) return report::FigureSection{};
  LUEUR_TRY(by_point, gather(session, scene, path, "point", setup));
  LUEUR_TRY(by_disc, gather(session, scene, path, "disc", setup));

  const Mask surfaces = mask_of(*find_layer(path, "depth"));
  const Methods methods = {
      {{"equation (3), point to point", &by_point, false},
       {"equation (4), point to disc", &by_disc, false},
       {"path traced", find_layer(path, "indirect"), true},
       {"path traced, what the camera sees", find_layer(screen, "indirect"), true},
       {"equation (4) over all pixels", find_layer(sum, "indirect"), true}}};

  report::PictureRow pictures{{}, "Incident indirect light, E/π, one bounce."};
  report::Plot plot{"Luminance of E/π along the line in the pictures",
                    {"pixel", false},
                    {"E/π, cd/m²", false},
                    {}};
  LUEUR_TRY(table, error_table(methods, surfaces));
  const auto y = static_cast<double>(slice_row(by_disc)) + 0.5;
  const float exposure_ev = scene.exposure_ev.value_or(0.0f) + 1.0f;
  for (const Method& method : methods) {
    pictures.pictures.push_back({to_display(*method.light, exposure_ev, ToneMap::khronos_neutral),
                                 method.name,
                                 {{0.0, y, static_cast<double>(side), y}}});
    plot.curves.push_back(slice(method));
  }
  report::FigureSection section;
  section.blocks = {
      report::Paragraph{
          "cornell, " + std::to_string(side) + " x " + std::to_string(side) +
          ". Both equations gather from a traced image of direct light: r = 40, 4 levels, 64 "
          "samples a level, full resolution, no filter over time. The paper: the spikes of "
          "equation (3) "
          "where surfaces meet are not there in equation (4)."},
      pictures, plot, table,
      report::Paragraph{
          "The truth has more light than any screen-space method can know of where the lit surface "
          "is turned away from the camera or hidden, and less where something stands between: "
          "“what the camera sees” is the first alone, “all pixels” the first and the second."}};
  return section;
}

}  // namespace lueur::cli::hssil
