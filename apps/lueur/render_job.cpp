// SPDX-License-Identifier: MIT
#include "render_job.h"

#include <algorithm>
#include <optional>

#include "arguments.h"
#include "base/try.h"
#include "console.h"
#include "interrupt.h"
#include "picture.h"
#include "render_frames.h"
#include "render_output.h"
#include "render_report.h"
#include "session.h"
#include "timing.h"

namespace lueur::cli {
namespace {

// Renders the picture, twice when times are asked for.
Result<FrameRecord> render_picture(const RenderJob& job, Session& session, Renderer& renderer,
                                   const Shot& shot, RenderReport& report) {
  Technique* technique = job.technique.technique.get();
  if (job.json) {
    LUEUR_TRY(first, render_frame(session, renderer, shot, technique, {}));
    static_cast<void>(first);
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
  return render_frame(session, renderer, shot, technique, images);
}

Result<void> write_outputs(const RenderJob& job, const FrameRecord& frame,
                           const Development& development, RenderReport& report) {
  LUEUR_TRY_VOID(write_frame(job.view, job.destinations, frame, development));
  for (const Destination& destination : job.destinations)
    report.outputs.push_back(destination.path.string());
  if (job.dump.empty()) return {};
  LUEUR_TRY(dumps, write_dumps(job.dump_to, frame.pixels, development));
  if (dumps.empty())
    return Error{ErrorKind::usage,
                 "--dump " + joined(job.dump) + ": matches none of " + joined(frame.written)};
  report.outputs.insert(report.outputs.end(), dumps.begin(), dumps.end());
  return {};
}

// One picture: renders it, writes it, and fills in the report.
Result<void> make_picture(const RenderJob& job, Session& session, Renderer& renderer,
                          const Scene& scene, const Cameras& cameras, RenderReport& report) {
  const Shot shot = moving_shot(job.pace, job.setup, cameras, 0);
  LUEUR_TRY(frame, render_picture(job, session, renderer, shot, report));
  report.passes = frame.passes;
  report.technique_ms = technique_ms(frame.passes, job.technique);
  report.host_ms = host_ms(frame.passes, job.technique);
  report.frame_ms = total_ms(frame.passes, "");
  report.findings = frame.findings;
  report.views = frame.written;
  report.off_screen_share = off_screen_share(frame.pixels, job.technique.diffuse_alpha());
  report.exposure_ev = exposure_ev(job.exposure, scene.exposure_ev,
                                   as_image(*find_pixels(frame.pixels, "composed"), 3));
  const Development development{.exposure_ev = report.exposure_ev,
                                .tone_map = job.tone_map,
                                .near_m = scene.cameras[static_cast<size_t>(cameras.main)].near_m,
                                .diffuse_alpha = job.technique.diffuse_alpha(),
                                .attributes = attributes(job, report, shot)};
  LUEUR_TRY_VOID(write_outputs(job, frame, development, report));
  for (const std::string& path : report.outputs) print_progress("wrote " + path);
  return {};
}

std::string lines(const std::vector<std::string>& list) {
  std::string text;
  for (const std::string& line : list) text += line + "\n";
  return text;
}

int end_of(const RenderJob& job, const RenderReport& report) {
  if (job.frames && *report.frames < job.frames->count()) {
    print_warning("interrupted: " + std::to_string(*report.frames) + " of " +
                  std::to_string(job.frames->count()) + " frames are written");
    return kExitInterrupted;
  }
  return print_findings(report);
}

}  // namespace

Outcome run_render(RenderJob& job) {
  // A single picture has nothing to stop between.
  std::optional<InterruptWatch> watch;
  if (job.frames) watch.emplace();

  RenderReport report;
  print_progress("loading " + job.scene);
  LUEUR_TRY(loaded, load_scene(job.scene, job.setup.environment, job.limits));
  const Scene& scene = loaded.scene;
  report.load_ms = loaded.load_ms;
  report.triangles = triangle_count(scene);
  LUEUR_TRY(cameras, find_cameras(scene, job.camera, job.side_cameras));
  report.camera = scene.cameras[static_cast<size_t>(cameras.main)].name;
  report.warnings = scene.warnings;

  LUEUR_TRY(session, open_session({.device = job.device, .validation = job.validate}));
  report.device = session.system->device();
  LUEUR_TRY(renderer, Renderer::create(*session.system, session.context, scene));
  report.warnings.insert(report.warnings.end(), renderer->warnings().begin(),
                         renderer->warnings().end());
  for (const std::string& warning : report.warnings) print_warning(warning);

  print_progress("rendering on " + report.device.name);
  if (job.frames)
    LUEUR_TRY_VOID(render_frames(job, session, *renderer, scene, cameras, watch->token(), report));
  else
    LUEUR_TRY_VOID(make_picture(job, session, *renderer, scene, cameras, report));
  report.validation_messages = session.system->validation_messages();

  if (job.json) {
    LUEUR_TRY_VOID(print_json(report_json(job, report)));
  } else if (job.list_views) {
    LUEUR_TRY_VOID(print_data(lines(report.views)));
  }
  return end_of(job, report);
}

}  // namespace lueur::cli
