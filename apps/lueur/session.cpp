// SPDX-License-Identifier: MIT
#include "session.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <filesystem>

#include "arguments.h"
#include "base/file.h"
#include "base/try.h"
#include "scene/builtin/builtin.h"
#include "scene/framing.h"
#include "scene/scene_file.h"

namespace lueur::cli {
namespace {

constexpr size_t kMostNamesInErrors = 24;

bool looks_like_file(const std::string& spec) {
  std::error_code error;
  return has_scene_ending(spec) || std::filesystem::exists(spec, error);
}

// That --object was given with something that has no object to give way to it.
Error no_object(const std::string& scene) {
  std::vector<std::string> names;
  for (const BuiltinScene& builtin : builtin_scenes())
    if (builtin.has_object) names.emplace_back(builtin.name);
  return {ErrorKind::usage,
          "scene '" + scene + "': --object needs a built-in scene that has one: " + joined(names)};
}

Result<void> surround(Scene& scene, const EnvironmentChoice& choice) {
  if (choice.file.empty()) return {};
  LUEUR_TRY(environment, load_environment(choice, scene.warnings));
  scene.environment = std::move(environment);
  return {};
}

Result<Scene> make_scene(const std::string& spec, const EnvironmentChoice& environment,
                         const LoadLimits& limits) {
  if (is_builtin(spec)) {
    LUEUR_TRY(scene, make_builtin_scene(spec));
    LUEUR_TRY_VOID(surround(scene, environment));
    return std::move(scene);
  }
  if (const size_t object = spec.find(":object="); object != std::string::npos)
    return no_object(spec.substr(0, object));
  if (looks_like_file(spec)) {
    LUEUR_TRY(scene, load_scene_file(spec, limits));
    // First what shines, as complete() adds a light where nothing does.
    LUEUR_TRY_VOID(surround(scene, environment));
    complete(scene);
    return std::move(scene);
  }
  std::vector<std::string> names;
  for (const BuiltinScene& scene : builtin_scenes()) names.emplace_back(scene.name);
  return Error{ErrorKind::usage, "scene '" + spec + "': neither a file (" +
                                     std::string(kSceneFileEndings) + ") nor one of " +
                                     joined(names)};
}

// The error names `flag` and lists the cameras.
Result<int32_t> camera_named(const Scene& scene, const std::string& flag, const std::string& text) {
  const std::vector<Camera>& cameras = scene.cameras;
  for (size_t i = 0; i < cameras.size(); ++i)
    if (cameras[i].name == text) return static_cast<int32_t>(i);
  size_t index = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, index);
  if (error == std::errc() && stop == end && index < cameras.size())
    return static_cast<int32_t>(index);

  std::vector<std::string> list;
  for (size_t i = 0; i < std::min(cameras.size(), kMostNamesInErrors); ++i)
    list.push_back(std::to_string(i) + " (" + cameras[i].name + ")");
  if (cameras.size() > kMostNamesInErrors) list.emplace_back("…");
  return Error{ErrorKind::usage,
               flag + " '" + text + "': the scene has the cameras " + joined(list)};
}

// Each device and driver has a file of its own: a driver ignores what another one has stored.
std::filesystem::path pipeline_cache(const gpu::DeviceEntry& device) {
  const std::filesystem::path folder = cache_folder();
  if (folder.empty()) return {};
  uint64_t hash = 0xcbf29ce484222325u;  // FNV-1a, 64 bits
  for (const char c : device.name + "\n" + device.driver + "\n" + device.api_version)
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  char digits[16];
  const auto end = std::to_chars(digits, digits + sizeof(digits), hash, 16).ptr;
  return folder / ("pipelines-" + std::string(digits, end) + ".bin");
}

std::vector<PassTime> summed_by_name(const std::vector<PassTime>& passes) {
  std::vector<PassTime> rows;
  for (const PassTime& pass : passes) {
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [&](const PassTime& r) { return r.name == pass.name; });
    if (row == rows.end())
      rows.push_back(pass);
    else
      row->gpu_ms += pass.gpu_ms;
  }
  return rows;
}

Image image_named(const RenderedImages& images, std::string_view name) {
  constexpr std::pair<std::string_view, Image RenderedImages::*> kImages[] = {
      {"depth", &RenderedImages::depth},
      {"normal", &RenderedImages::normal},
      {"albedo", &RenderedImages::albedo},
      {"material", &RenderedImages::material},
      {"emission", &RenderedImages::emission},
      {"motion", &RenderedImages::motion},
      {"source", &RenderedImages::source},
      {"specular", &RenderedImages::specular},
      {"indirect", &RenderedImages::indirect},
      {"indirect_specular", &RenderedImages::indirect_specular},
      {"occlusion", &RenderedImages::occlusion},
      {"composed", &RenderedImages::composed}};
  for (const auto& [known, image] : kImages)
    if (known == name) return images.*image;
  return {};
}

}  // namespace

bool is_builtin(const std::string& spec) {
  const auto scenes = builtin_scenes();
  const std::string name = spec.substr(0, spec.find(':'));
  return std::any_of(scenes.begin(), scenes.end(),
                     [&](const BuiltinScene& scene) { return scene.name == name; });
}

Result<LoadedScene> load_scene(const std::string& spec, const EnvironmentChoice& environment,
                               const LoadLimits& limits) {
  const auto start = std::chrono::steady_clock::now();
  LUEUR_TRY(scene, make_scene(spec, environment, limits));
  const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
  return LoadedScene{std::move(scene), taken.count()};
}

Result<int32_t> find_camera(const Scene& scene, const std::string& text) {
  if (text.empty() && !scene.cameras.empty()) return 0;
  return camera_named(scene, "--camera", text);
}

Result<Cameras> find_cameras(const Scene& scene, const std::string& main,
                             const std::vector<std::string>& side) {
  LUEUR_TRY(camera, find_camera(scene, main));
  Cameras cameras{camera};
  for (const std::string& text : side) {
    LUEUR_TRY(index, camera_named(scene, "--side-camera", text));
    cameras.side.push_back(index);
  }
  return cameras;
}

Result<Session> open_session(const gpu::SystemInfo& info) {
  LUEUR_TRY(system, gpu::System::create(info));
  ContextInfo context_info = system->context_info();
  context_info.frames_in_flight = 1;
  context_info.timers = Timers::passes;
  context_info.pipeline_cache = pipeline_cache(system->device());
  LUEUR_TRY(context, Context::create(context_info));
  return Session{std::move(system), std::move(context)};
}

Result<FrameRecord> render_frame(Session& session, Renderer& renderer, const Shot& shot,
                                 Technique* technique, const ImageNames& images) {
  Recorder& recorder = session.context.recorder();
  LUEUR_TRY_VOID(session.system->run([&](VkCommandBuffer commands) -> Result<void> {
    Frame frame = session.context.record(commands);
    const RenderedImages rendered = renderer.record(frame, shot, technique);
    for (const std::string_view name : images)
      recorder.read_back(std::string(name), image_named(rendered, name));
    return frame.finish();
  }));
  FrameRecord record;
  record.passes = summed_by_name(session.context.pass_times());
  record.pixels = recorder.read_back_pixels();
  record.findings = recorder.scan_findings();
  for (const std::string& name : recorder.written_images())
    if (std::find(record.written.begin(), record.written.end(), name) == record.written.end())
      record.written.push_back(name);
  return record;
}

double total_ms(const std::vector<PassTime>& passes, std::string_view prefix) {
  double total = 0;
  for (const PassTime& pass : passes)
    if (pass.name.starts_with(prefix)) total += pass.gpu_ms;
  return total;
}

}  // namespace lueur::cli
