// SPDX-License-Identifier: MIT
#include "reference_job.h"

#include <cmath>

#include "base/file.h"
#include "base/try.h"
#include "console.h"
#include "image/png.h"
#include "interrupt.h"
#include "json_output.h"
#include "reference_trace.h"
#include "session.h"

namespace lueur::cli {
namespace {

namespace fs = std::filesystem;

constexpr uint64_t kMaxStateBytes = uint64_t{1} << 36;

// The one input of a rendering that may be at fault is the state, and it has a name.
Error of_state_file(const ReferenceJob& job, Error error) {
  if (error.kind == ErrorKind::input)
    error.message = state_path(job).string() + ": " + error.message;
  return error;
}

Result<reference::CachedRendering> trace(const ReferenceJob& job, const Scene& scene,
                                         const std::stop_token& stop) {
  std::vector<uint8_t> state;
  if (job.resume) {
    auto bytes = read_file(state_path(job), kMaxStateBytes);
    if (!bytes.ok())
      return Error{bytes.error().kind, bytes.error().message + "; start anew without --resume"};
    state = std::move(*bytes);
  }
  reference::Control control{
      .threads = job.threads,
      .progress = [](const reference::Progress& p) { print_progress(describe(p)); },
      .stop = stop,
      .checkpoint =
          [&](const std::vector<uint8_t>& bytes) {
            if (const auto kept = write_file(state_path(job), bytes); !kept.ok())
              print_warning(kept.error().message);
          }};
  auto traced = reference::render_cached(scene, job.shot, job.settings, control, state, job.cache);
  return traced.ok() ? std::move(traced) : of_state_file(job, traced.error());
}

std::map<std::string, std::string> attributes(const ReferenceJob& job) {
  const reference::Settings& s = job.settings;
  std::map<std::string, std::string> list = {
      {"lueur.version", LUEUR_VERSION},
      {"lueur.scene", job.scene},
      {"lueur.camera", job.camera},
      {"lueur.environment", environment_json(job.environment).dump()},
      {"lueur.time_s", std::to_string(job.shot.time_s)},
      {"lueur.reference.mode", std::string(name_of(s.mode))},
      {"lueur.reference.seed", std::to_string(s.seed)}};
  if (s.mode == reference::Mode::path || s.mode == reference::Mode::screen)
    list["lueur.reference.bounces"] = std::to_string(s.bounces);
  if (s.mode == reference::Mode::ambient)
    list["lueur.reference.distance_m"] = std::to_string(s.ambient_distance_m);
  return list;
}

// The picture as a display shows it; of ambient, the occlusion as it is.
Image8 display_picture(const ReferenceJob& job, const Scene& scene,
                       const reference::Rendering& rendering) {
  if (const ImageF* occlusion = find_layer(rendering, "occlusion"))
    return to_display(*occlusion, 0.0f, ToneMap::none);
  const ImageF& picture = *find_layer(rendering, "");
  return to_display(picture, exposure_ev(job.exposure, scene.exposure_ev, picture), job.tone_map);
}

Result<void> write(const ReferenceJob& job, const Scene& scene,
                   const reference::Rendering& rendering) {
  for (const Destination& destination : job.destinations) {
    if (destination.kind == FileKind::exr) {
      LUEUR_TRY_VOID(write_rendering(destination.path, rendering, attributes(job)));
    } else {
      LUEUR_TRY_VOID(write_png(destination.path, display_picture(job, scene, rendering)));
    }
    print_progress("wrote " + destination.path.string());
  }
  // What continues the rendering is kept as long as there is something to continue.
  if (!rendering.complete) return write_file(state_path(job), rendering.state);
  std::error_code ignored;
  fs::remove(state_path(job), ignored);
  return {};
}

Json report_json(const ReferenceJob& job, const reference::CachedRendering& result) {
  const reference::Progress& p = result.rendering.progress;
  Json json = {
      {"version", LUEUR_VERSION},
      {"scene", job.scene},
      {"camera", job.camera},
      {"environment", environment_json(job.environment)},
      {"size", size_json({job.shot.width, job.shot.height})},
      {"mode", name_of(job.settings.mode)},
      {"bounces", job.settings.bounces},
      {"seed", job.settings.seed},
      {"spp", p.spp_done},
      {"relative_error", std::isfinite(p.relative_error) ? Json(p.relative_error) : Json(nullptr)},
      {"seconds", p.seconds},
      {"rays", p.rays},
      {"rays_per_s", p.seconds > 0 ? static_cast<double>(p.rays) / p.seconds : 0.0},
      {"complete", result.rendering.complete},
      {"from_cache", result.from_cache}};
  Json outputs = Json::array();
  for (const Destination& destination : job.destinations)
    outputs.push_back(destination.path.string());
  json["outputs"] = std::move(outputs);
  return json;
}

}  // namespace

fs::path state_path(const ReferenceJob& job) {
  fs::path path = job.destinations.front().path;
  return path += ".resume";
}

Outcome run_reference(ReferenceJob& job) {
  print_progress("loading " + job.scene);
  LUEUR_TRY(loaded, load_scene(job.scene, job.environment, job.limits));
  const Scene& scene = loaded.scene;
  LUEUR_TRY(camera, find_camera(scene, job.camera));
  job.shot.camera = camera;
  job.camera = scene.cameras[static_cast<size_t>(camera)].name;
  for (const std::string& warning : scene.warnings) print_warning(warning);

  const InterruptWatch watch;
  LUEUR_TRY(result, trace(job, scene, watch.token()));
  if (!result.cache_note.empty()) print_warning(result.cache_note);
  LUEUR_TRY_VOID(write(job, scene, result.rendering));
  if (job.json) LUEUR_TRY_VOID(print_json(report_json(job, result)));
  if (result.rendering.complete) return kExitDone;
  print_warning("interrupted after " + std::to_string(result.rendering.progress.spp_done) +
                " samples a pixel; the same command with --resume goes on");
  return kExitInterrupted;
}

}  // namespace lueur::cli
