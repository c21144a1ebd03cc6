// SPDX-License-Identifier: MIT
#include "sequence_job.h"

#include <cstdio>
#include <optional>

#include "base/try.h"
#include "console.h"
#include "image/exposure.h"
#include "json_output.h"
#include "picture.h"
#include "render_output.h"
#include "scene/hold.h"

namespace lueur::cli {
namespace {

std::filesystem::path frame_path(const SequenceJob& job, const ChosenTechnique& technique,
                                 uint32_t frame) {
  char ending[24];
  std::snprintf(ending, sizeof(ending), "-%04u.png", frame);
  return job.folder / (file_stem(technique.label) + ending);
}

// Whether the frames can be written, as far as that shows before the first is rendered.
Result<void> check_output(const SequenceJob& job) {
  std::vector<std::string> first_frames;
  for (const ChosenTechnique& technique : job.techniques)
    first_frames.push_back(frame_path(job, technique, 0).string());
  LUEUR_TRY(checked, check_destinations(first_frames, job.sequence.setup.size));
  static_cast<void>(checked);
  return {};
}

void hold(Scene& scene, int32_t camera, const SequenceJob& job) {
  if (job.hold == Hold::camera) hold_camera(scene, camera, job.sequence.pace.from_s);
  if (job.hold == Hold::scene) hold_all_but_camera(scene, camera, job.sequence.pace.from_s);
}

// Measures all techniques in turn. The first frame's exposure is that of all.
Result<std::vector<SequenceErrors>> measure(const SequenceJob& job, Session& session,
                                            Renderer& renderer, const Scene& scene,
                                            const Cameras& cameras) {
  std::optional<float> exposure_ev = scene.exposure_ev;
  std::vector<SequenceErrors> all;
  for (const ChosenTechnique& technique : job.techniques) {
    const auto write = [&](uint32_t frame, std::span<const Pixels> pixels) -> Result<void> {
      if (job.folder.empty()) return {};
      if (!exposure_ev)
        exposure_ev = auto_exposure_ev(as_image(*find_pixels(pixels, "composed"), 3));
      return write_pictures({{frame_path(job, technique, frame), FileKind::png}}, pixels,
                            {.exposure_ev = *exposure_ev, .diffuse_alpha = {}, .attributes = {}});
    };
    LUEUR_TRY(errors,
              measure_sequence(session, renderer, scene, cameras, job.sequence, technique, write));
    all.push_back(errors);
  }
  return all;
}

Json report_json(const SequenceJob& job, const std::vector<SequenceErrors>& all,
                 const std::string& camera, const gpu::DeviceEntry& device) {
  const Sequence& sequence = job.sequence;
  constexpr const char* kHeld[] = {"nothing", "camera", "scene"};
  Json rows = Json::array();
  for (size_t i = 0; i < all.size(); ++i) {
    const ChosenTechnique& technique = job.techniques[i];
    rows.push_back({{"label", technique.label},
                    {"technique", technique.name()},
                    {"settings", settings_json(technique.info, technique.technique.get())},
                    {"flicker", all[i].change.flicker()},
                    {"reference_flicker", all[i].reference_change.flicker()},
                    {"excess", all[i].excess()},
                    {"ghost_bias", all[i].ghosts.bias()},
                    {"ghost_error", all[i].ghosts.error()},
                    {"ghost_pixels", all[i].ghosts.pixels}});
  }
  return {{"version", LUEUR_VERSION},
          {"scene", job.scene},
          {"camera", camera},
          {"environment", environment_json(sequence.setup.environment)},
          {"device", device_json(device)},
          {"size", size_json(sequence.setup.size)},
          {"from_s", as_printed(sequence.pace.from_s)},
          {"rate", as_printed(sequence.pace.rate)},
          {"frames", sequence.frames},
          {"seed", sequence.setup.seed},
          {"fixed_seed", sequence.pace.fixed_seed},
          {"hold", kHeld[static_cast<size_t>(job.hold)]},
          {"settle", sequence.settle},
          {"average", sequence.average},
          {"uncovered", sequence.uncovered},
          {"techniques", std::move(rows)}};
}

constexpr size_t kNameColumns = 36;

// The first column of a row; a long name takes a line of its own.
std::string name_cell(const std::string& label) {
  std::string cell = printable(label);
  if (cell.size() < kNameColumns) return cell + std::string(kNameColumns - cell.size(), ' ');
  return cell + "\n" + std::string(kNameColumns, ' ');
}

std::string report_text(const SequenceJob& job, const std::vector<SequenceErrors>& all) {
  std::string text = name_cell("technique") +
                     "  flicker reference    excess     ghost     ghost     ghost\n" +
                     name_cell("") + "                                 bias     error    pixels\n";
  for (size_t i = 0; i < all.size(); ++i) {
    const SequenceErrors& errors = all[i];
    char numbers[128];
    std::snprintf(numbers, sizeof(numbers), "%9.4f %9.4f %+9.4f %+9.4f %9.4f %9llu\n",
                  errors.change.flicker(), errors.reference_change.flicker(), errors.excess(),
                  errors.ghosts.bias(), errors.ghosts.error(),
                  static_cast<unsigned long long>(errors.ghosts.pixels));
    text += name_cell(job.techniques[i].label) + numbers;
  }
  return text;
}

}  // namespace

Outcome run_sequence(SequenceJob& job) {
  if (!job.folder.empty()) LUEUR_TRY_VOID(check_output(job));
  print_progress("loading " + job.scene);
  LUEUR_TRY(loaded, load_scene(job.scene, job.sequence.setup.environment, job.limits));
  Scene& scene = loaded.scene;
  LUEUR_TRY(cameras, find_cameras(scene, job.frame.camera, job.frame.side_cameras));
  hold(scene, cameras.main, job);

  LUEUR_TRY(session, open_session({.device = job.frame.device}));
  LUEUR_TRY(renderer, Renderer::create(*session.system, session.context, scene));
  for (const std::string& warning : scene.warnings) print_warning(warning);
  for (const std::string& warning : renderer->warnings()) print_warning(warning);

  print_progress("rendering on " + session.system->device().name);
  LUEUR_TRY(all, measure(job, session, *renderer, scene, cameras));
  const std::string& camera_name = scene.cameras[static_cast<size_t>(cameras.main)].name;
  LUEUR_TRY_VOID(job.json ? print_json(report_json(job, all, camera_name, session.system->device()))
                          : print_data(report_text(job, all)));
  return kExitDone;
}

}  // namespace lueur::cli
