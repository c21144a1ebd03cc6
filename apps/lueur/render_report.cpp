// SPDX-License-Identifier: MIT
#include "render_report.h"

#include "console.h"

namespace lueur::cli {
namespace {

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

}  // namespace

std::map<std::string, std::string> attributes(const RenderJob& job, const RenderReport& report,
                                              const Shot& shot) {
  const ChosenTechnique& technique = job.technique;
  return {{"lueur.version", LUEUR_VERSION},
          {"lueur.scene", job.scene},
          {"lueur.camera", report.camera},
          {"lueur.environment", environment_json(job.setup.environment).dump()},
          {"lueur.technique", technique.name()},
          {"lueur.settings", settings_json(technique.info, technique.technique.get()).dump()},
          {"lueur.seed", std::to_string(shot.seed)},
          {"lueur.time_s", std::to_string(shot.time_s)},
          {"lueur.exposure_ev", std::to_string(report.exposure_ev)},
          {"lueur.device", report.device.name}};
}

Json report_json(const RenderJob& job, const RenderReport& report) {
  const ChosenTechnique& technique = job.technique;
  Json json = {{"version", LUEUR_VERSION},
               {"scene", job.scene},
               {"camera", report.camera},
               {"environment", environment_json(job.setup.environment)},
               {"device", device_json(report.device)},
               {"size", size_json(job.setup.size)},
               {"technique", technique.name()},
               {"settings", settings_json(technique.info, technique.technique.get())},
               {"seed", job.setup.seed},
               {"time_s", as_printed(job.pace.from_s)}};
  if (job.frames) {
    json["fps"] = as_printed(job.pace.rate);
    json["first_frame"] = job.frames->first;
    json["last_frame"] = job.frames->last;
    json["settle"] = job.settle;
    json["frames"] = *report.frames;
  }
  json["exposure_ev"] = as_printed(report.exposure_ev);
  json["tone_map"] = job.tone_map_name;
  json["passes"] = passes_json(report.passes);
  json["technique_ms"] = rounded_ms(report.technique_ms);
  json["host_ms"] = rounded_ms(report.host_ms);
  json["frame_ms"] = rounded_ms(report.frame_ms);
  if (report.memory) {
    json["memory_bytes"] = report.memory->total_bytes;
    json["peak_memory_bytes"] = report.memory->peak_bytes;
  }
  json["triangles"] = report.triangles;
  json["load_ms"] = rounded_ms(report.load_ms);
  json["outputs"] = report.outputs;
  json["warnings"] = report.warnings;
  if (report.off_screen_share) json["off_screen_share"] = *report.off_screen_share;
  if (job.list_views) json["views"] = report.views;
  if (job.scan) json["findings"] = findings_json(report.findings);
  if (job.validate) json["validation_messages"] = report.validation_messages;
  return json;
}

int print_findings(const RenderReport& report) {
  for (const ScanFinding& f : report.findings)
    print_error("scan: " + f.image + ": " + std::to_string(f.nan) + " NaN, " +
                std::to_string(f.infinite) + " infinite and " + std::to_string(f.negative) +
                " negative pixels, the first at (" + std::to_string(f.first_x) + ", " +
                std::to_string(f.first_y) + ")");
  for (const std::string& message : report.validation_messages)
    print_error("validation: " + message);
  return report.findings.empty() && report.validation_messages.empty() ? kExitDone : kExitFinding;
}

}  // namespace lueur::cli
