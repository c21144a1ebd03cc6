// SPDX-License-Identifier: MIT
#include "render_job.h"

#include <algorithm>
#include <cstdio>

#include "arguments.h"
#include "base/try.h"
#include "console.h"
#include "json_output.h"
#include "picture.h"
#include "render_output.h"
#include "session.h"

namespace lueur::cli {
namespace {

// Motion vectors are those of an animation of this rate.
constexpr float kFrameSeconds = 1.0f / 60.0f;

// What the steps below have found out, for the report.
struct Report {
  FrameRecord frame;
  MemoryUse memory;
  std::vector<std::string> warnings;
  std::vector<std::string> validation_messages;
  std::vector<std::string> outputs;
  std::string camera;
  uint64_t triangles = 0;
  double load_ms = 0;
};

bool has(const std::vector<std::string>& list, const std::string& text) {
  return std::find(list.begin(), list.end(), text) != list.end();
}

// Renders the frame, twice when times are asked for.
Result<void> render(const RenderJob& job, Session& session, Renderer& renderer, const Shot& shot,
                    Report& report) {
  Technique* technique = job.technique.technique.get();
  if (job.json) {
    LUEUR_TRY(first, render_frame(session, renderer, shot, technique, {}));
    report.frame = std::move(first);
    // Both frames start from nothing, so that the picture is the same with and without --json.
    session.context.recorder().forget_history();
    // Copies for the CPU are not what rendering needs: memory is that of the frame before them.
    report.memory = session.context.memory();
  }
  RecorderOptions& inspect = session.context.recorder().options;
  inspect.scan = job.scan;
  inspect.watch = job.dump;
  if (!job.view.empty()) inspect.watch.push_back(job.view);
  const bool wants_layers =
      std::any_of(job.destinations.begin(), job.destinations.end(),
                  [](const Destination& d) { return d.kind == FileKind::exr; });
  ImageNames images = {"composed"};
  if (job.json) images = {"composed", "depth", "indirect"};
  if (wants_layers && job.view.empty()) images = kAllImages;
  LUEUR_TRY(frame, render_frame(session, renderer, shot, technique, images));
  report.frame = std::move(frame);
  return {};
}

std::map<std::string, std::string> attributes(const RenderJob& job, const Report& report,
                                              const gpu::DeviceEntry& device, float exposure_ev) {
  const ChosenTechnique& technique = job.technique;
  return {{"lueur.version", LUEUR_VERSION},
          {"lueur.scene", job.scene},
          {"lueur.camera", report.camera},
          {"lueur.environment", environment_json(job.environment).dump()},
          {"lueur.technique", technique.name()},
          {"lueur.settings", settings_json(technique.info, technique.technique.get()).dump()},
          {"lueur.seed", std::to_string(job.seed)},
          {"lueur.time_s", std::to_string(job.time_s)},
          {"lueur.exposure_ev", std::to_string(exposure_ev)},
          {"lueur.device", device.name}};
}

Result<void> write_outputs(const RenderJob& job, const Development& development, Report& report) {
  const std::vector<Pixels>& pixels = report.frame.pixels;
  if (job.view.empty()) {
    LUEUR_TRY_VOID(write_pictures(job.destinations, pixels, development));
  } else {
    const Pixels* view = find_pixels(pixels, job.view);
    if (!view && has(report.frame.written, job.view))
      return Error{ErrorKind::usage, "--view " + job.view +
                                         ": a cube map; only flat images can "
                                         "be shown, see --list-views"};
    if (!view)
      return Error{ErrorKind::usage, "--view " + job.view + ": no such image; this frame has " +
                                         joined(report.frame.written)};
    LUEUR_TRY_VOID(write_view(job.destinations, *view, development));
  }
  for (const Destination& destination : job.destinations)
    report.outputs.push_back(destination.path.string());
  if (job.dump.empty()) return {};
  LUEUR_TRY(dumps, write_dumps(job.dump_to, pixels, development));
  if (dumps.empty())
    return Error{ErrorKind::usage, "--dump " + joined(job.dump) + ": matches none of " +
                                       joined(report.frame.written)};
  report.outputs.insert(report.outputs.end(), dumps.begin(), dumps.end());
  return {};
}

Json findings_json(const std::vector<ScanFinding>& findings) {
  Json list = Json::array();
  for (const ScanFinding& f : findings)
    list.push_back({{"image", f.image},
                    {"nan", f.nan},
                    {"infinite", f.infinite},
                    {"negative", f.negative},
                    {"first", Json::array({f.first_x, f.first_y})}});
  return list;
}

Json report_json(const RenderJob& job, const Report& report, const gpu::DeviceEntry& device,
                 float exposure_ev) {
  const ChosenTechnique& technique = job.technique;
  Json json = {
      {"version", LUEUR_VERSION},
      {"scene", job.scene},
      {"camera", report.camera},
      {"environment", environment_json(job.environment)},
      {"device", device_json(device)},
      {"size", size_json(job.size)},
      {"technique", technique.name()},
      {"settings", settings_json(technique.info, technique.technique.get())},
      {"seed", job.seed},
      {"time_s", as_printed(job.time_s)},
      {"exposure_ev", as_printed(exposure_ev)},
      {"tone_map", job.tone_map_name},
      {"passes", passes_json(report.frame.passes)},
      {"technique_ms",
       technique.info ? rounded_ms(total_ms(report.frame.passes, technique.name() + ".")) : 0.0},
      {"frame_ms", rounded_ms(total_ms(report.frame.passes, ""))},
      {"memory_bytes", report.memory.total_bytes},
      {"peak_memory_bytes", report.memory.peak_bytes},
      {"triangles", report.triangles},
      {"load_ms", rounded_ms(report.load_ms)},
      {"outputs", report.outputs},
      {"warnings", report.warnings}};
  if (technique.name() == "hierarchical")
    if (const auto share = off_screen_share(report.frame.pixels)) json["off_screen_share"] = *share;
  if (job.list_views) json["views"] = report.frame.written;
  if (job.scan) json["findings"] = findings_json(report.frame.findings);
  if (job.validate) json["validation_messages"] = report.validation_messages;
  return json;
}

// Says on stderr what the checks have found.
int print_findings(const Report& report) {
  for (const ScanFinding& f : report.frame.findings)
    print_error("scan: " + f.image + ": " + std::to_string(f.nan) + " NaN, " +
                std::to_string(f.infinite) + " infinite and " + std::to_string(f.negative) +
                " negative pixels, the first at (" + std::to_string(f.first_x) + ", " +
                std::to_string(f.first_y) + ")");
  for (const std::string& message : report.validation_messages)
    print_error("validation: " + message);
  return report.frame.findings.empty() && report.validation_messages.empty() ? kExitDone
                                                                             : kExitFinding;
}

std::string lines(const std::vector<std::string>& list) {
  std::string text;
  for (const std::string& line : list) text += line + "\n";
  return text;
}

}  // namespace

Outcome run_render(RenderJob& job) {
  Report report;
  print_progress("loading " + job.scene);
  LUEUR_TRY(loaded, load_scene(job.scene, job.environment, job.limits));
  const Scene& scene = loaded.scene;
  report.load_ms = loaded.load_ms;
  report.triangles = triangle_count(scene);
  LUEUR_TRY(camera, find_camera(scene, job.camera));
  report.camera = scene.cameras[camera].name;
  report.warnings = scene.warnings;

  LUEUR_TRY(session, open_session({.device = job.device, .validation = job.validate}));
  const gpu::DeviceEntry& device = session.system->device();
  LUEUR_TRY(renderer, Renderer::create(*session.system, session.context, scene));
  report.warnings.insert(report.warnings.end(), renderer->warnings().begin(),
                         renderer->warnings().end());
  for (const std::string& warning : report.warnings) print_warning(warning);

  print_progress("rendering on " + device.name);
  const Shot shot{.extent = job.size,
                  .camera = camera,
                  .time_s = job.time_s,
                  .previous_time_s = job.time_s - kFrameSeconds,
                  .seed = job.seed};
  LUEUR_TRY_VOID(render(job, session, *renderer, shot, report));
  report.validation_messages = session.system->validation_messages();

  Development development;
  development.exposure_ev = exposure_ev(job.exposure, scene.exposure_ev,
                                        as_image(*find_pixels(report.frame.pixels, "composed"), 3));
  development.tone_map = job.tone_map;
  development.near_m = scene.cameras[camera].near_m;
  development.attributes = attributes(job, report, device, development.exposure_ev);
  LUEUR_TRY_VOID(write_outputs(job, development, report));
  for (const std::string& path : report.outputs) print_progress("wrote " + path);

  if (job.json) {
    LUEUR_TRY_VOID(print_json(report_json(job, report, device, development.exposure_ev)));
  } else if (job.list_views) {
    LUEUR_TRY_VOID(print_data(lines(report.frame.written)));
  }
  return print_findings(report);
}

}  // namespace lueur::cli
