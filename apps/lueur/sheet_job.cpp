// SPDX-License-Identifier: MIT
#include "sheet_job.h"

#include <algorithm>
#include <new>

#include "arguments.h"
#include "base/try.h"
#include "console.h"
#include "image/png.h"
#include "interrupt.h"
#include "json_output.h"
#include "picture.h"
#include "report/sheet.h"
#include "session.h"

namespace lueur::cli {
namespace {

// A file may have any number of cameras; so many pictures of one scene are enough.
constexpr size_t kMostCameras = 64;

// What came of the scenes, in their order.
struct Drawing {
  report::Sheet sheet;
  Json scenes = Json::array();
};

Result<report::SheetPicture> draw_camera(const SheetJob& job, Session& session, Renderer& renderer,
                                         const Scene& scene, size_t camera) {
  // No picture may depend on the ones before.
  session.context.recorder().forget_history();
  const Shot shot{.extent = job.size,
                  .camera = static_cast<int32_t>(camera),
                  .time_s = job.time_s,
                  .previous_time_s = job.time_s};
  LUEUR_TRY(frame,
            render_frame(session, renderer, shot, job.technique.technique.get(), {"composed"}));
  const ImageF composed = as_image(*find_pixels(frame.pixels, "composed"), 3);
  const float ev = exposure_ev({}, scene.exposure_ev, composed);
  LUEUR_TRY(png, encode_png(to_display(composed, ev, ToneMap::khronos_neutral), scene.name));
  return report::SheetPicture{scene.cameras[camera].name, ev, std::move(png)};
}

// Scene and renderer live no longer than this call, so that one scene at a time takes memory.
Result<report::SheetScene> draw_scene(const SheetJob& job, Session& session,
                                      const SceneSource& source, const std::stop_token& stop) {
  LUEUR_TRY(loaded, load_scene(source.spec, {}, job.limits));
  const Scene& scene = loaded.scene;
  LUEUR_TRY(renderer, Renderer::create(*session.system, session.context, scene));
  report::SheetScene drawn{.name = scene.name,
                           .source = source.label,
                           .triangles = triangle_count(scene),
                           .load_ms = loaded.load_ms,
                           .warnings = scene.warnings,
                           .pictures = {}};
  drawn.warnings.insert(drawn.warnings.end(), renderer->warnings().begin(),
                        renderer->warnings().end());
  size_t cameras = 1;
  if (job.all_cameras) cameras = std::min(scene.cameras.size(), kMostCameras);
  if (job.all_cameras && scene.cameras.size() > cameras)
    drawn.warnings.push_back("only the first " + std::to_string(cameras) + " of " +
                             std::to_string(scene.cameras.size()) + " cameras are shown");
  for (size_t camera = 0; camera < cameras && !stop.stop_requested(); ++camera) {
    LUEUR_TRY(picture, draw_camera(job, session, *renderer, scene, camera));
    drawn.pictures.push_back(std::move(picture));
  }
  return drawn;
}

// The same for a scene that may take more memory than there is. Errors name the scene.
Result<report::SheetScene> try_scene(const SheetJob& job, Session& session,
                                     const SceneSource& source, const std::stop_token& stop) {
  try {
    auto drawn = draw_scene(job, session, source, stop);
    if (drawn.ok()) return drawn;
    Error error = drawn.error();
    if (error.message.find(source.spec) == std::string::npos)
      error.message = source.spec + ": " + error.message;
    return error;
  } catch (const std::bad_alloc&) {
    return Error{ErrorKind::memory, source.spec + ": not enough memory for this scene"};
  }
}

Json scene_json(const SceneSource& source, const report::SheetScene& drawn) {
  Json cameras = Json::array();
  for (const report::SheetPicture& picture : drawn.pictures)
    cameras.push_back({{"name", picture.camera}, {"exposure_ev", as_printed(picture.exposure_ev)}});
  return {{"scene", source.spec},          {"name", drawn.name},
          {"triangles", drawn.triangles},  {"load_ms", rounded_ms(drawn.load_ms)},
          {"cameras", std::move(cameras)}, {"warnings", drawn.warnings}};
}

// Without the file's name at its front: on the page it stands beside.
std::string reason_of(const Error& error, const SceneSource& source) {
  const std::string name = source.spec + ": ";
  return error.message.starts_with(name) ? error.message.substr(name.size()) : error.message;
}

// Fails only for what no other scene can mend: a lost device, or nothing drawn at all.
Result<Drawing> draw_all(const SheetJob& job, Session& session, const std::stop_token& stop) {
  Drawing drawing;
  report::Sheet& sheet = drawing.sheet;
  const size_t count = job.scenes.size();
  for (size_t i = 0; i < count && !stop.stop_requested(); ++i) {
    const SceneSource& source = job.scenes[i];
    print_progress(std::to_string(i + 1) + "/" + std::to_string(count) + " " + source.spec);
    auto drawn = try_scene(job, session, source, stop);
    if (drawn.ok()) {
      drawing.scenes.push_back(scene_json(source, *drawn));
      sheet.scenes.push_back(std::move(*drawn));
      continue;
    }
    const Error& error = drawn.error();
    if (error.kind == ErrorKind::device || count == 1) return error;
    print_warning(error.message);
    drawing.scenes.push_back({{"scene", source.spec}, {"error", error.message}});
    sheet.refused.push_back({source.label, reason_of(error, source)});
  }
  if (sheet.scenes.empty() && !stop.stop_requested())
    return Error{ErrorKind::input, "none of " + std::to_string(count) +
                                       " scenes could be drawn, see above; nothing was written"};
  return drawing;
}

Json report_json(const SheetJob& job, Drawing& drawing, const gpu::DeviceEntry& device) {
  const ChosenTechnique& technique = job.technique;
  return {{"version", LUEUR_VERSION},
          {"device", device_json(device)},
          {"size", size_json(job.size)},
          {"technique", technique.name()},
          {"settings", settings_json(technique.info, technique.technique.get())},
          {"time_s", as_printed(job.time_s)},
          {"output", job.page.string()},
          {"drawn", drawing.sheet.scenes.size()},
          {"refused", drawing.sheet.refused.size()},
          {"scenes", std::move(drawing.scenes)}};
}

std::string counted(size_t count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace

Outcome run_sheet(SheetJob& job) {
  // Before the device, whose threads would take its signals.
  const InterruptWatch watch;
  LUEUR_TRY(session, open_session({.device = job.device}));
  const gpu::DeviceEntry& device = session.system->device();
  LUEUR_TRY(drawing, draw_all(job, session, watch.token()));
  if (watch.token().stop_requested()) {
    print_warning("interrupted; nothing was written");
    return kExitInterrupted;
  }
  report::Sheet& sheet = drawing.sheet;
  sheet.title = "Contact sheet: " + counted(sheet.scenes.size(), "scene");
  sheet.facts = {
      {"technique", job.technique.label}, {"device", device.name}, {"version", LUEUR_VERSION}};
  sheet.command = job.command;
  sheet.width = job.size.width;
  sheet.height = job.size.height;
  LUEUR_TRY_VOID(write_sheet(sheet, job.page));
  print_progress("wrote " + job.page.string());
  const std::string text = "drawn: " + counted(sheet.scenes.size(), "scene") +
                           "\nnot drawn: " + std::to_string(sheet.refused.size()) + "\n";
  LUEUR_TRY_VOID(job.json ? print_json(report_json(job, drawing, device)) : print_data(text));
  return kExitDone;
}

}  // namespace lueur::cli
