// SPDX-License-Identifier: MIT
#include "candidate.h"

#include <algorithm>
#include <charconv>

#include "base/try.h"
#include "console.h"
#include "lueur/hierarchical.h"

namespace lueur::cli {
namespace {

using Scenes = std::vector<std::shared_ptr<SceneUnderTest>>;

// The scene of this name, loaded if it is not in the list yet.
Result<std::shared_ptr<SceneUnderTest>> scene_named(const std::string& name,
                                                    const EnvironmentChoice& environment,
                                                    const LoadLimits& limits,
                                                    const std::string& camera,
                                                    const std::vector<std::string>& side_cameras,
                                                    Session& session, Scenes& scenes) {
  const auto known = std::find_if(scenes.begin(), scenes.end(),
                                  [&](const auto& scene) { return scene->name == name; });
  if (known != scenes.end()) return *known;
  print_progress("loading " + name);
  LUEUR_TRY(loaded, load_scene(name, environment, limits));
  LUEUR_TRY(cameras, find_cameras(loaded.scene, camera, side_cameras));
  const uint64_t before = session.context.memory().total_bytes;
  LUEUR_TRY(renderer, Renderer::create(*session.system, session.context, loaded.scene));
  for (const std::string& warning : loaded.scene.warnings) print_warning(warning);
  for (const std::string& warning : renderer->warnings()) print_warning(warning);
  const uint64_t bytes = session.context.memory().total_bytes - before;
  scenes.push_back(std::make_shared<SceneUnderTest>(
      SceneUnderTest{name, triangle_count(loaded.scene), cameras,
                     loaded.scene.exposure_ev.value_or(0.0f), bytes, std::move(renderer)}));
  return scenes.back();
}

// Lets the recorder hold nothing but what the last frame used, and looks at what it holds after a
// frame without the technique and after one with it.
Result<CandidateMemory> measure_memory(Session& session, Candidate& candidate,
                                       uint64_t bytes_of_scenes) {
  Recorder& recorder = session.context.recorder();
  recorder.forget_history();
  recorder.options.idle_frames = 0;
  LUEUR_TRY(without,
            render_frame(session, *candidate.scene->renderer, candidate.shot, nullptr, {}));
  static_cast<void>(without);
  const uint64_t without_bytes = recorder.memory().total_bytes;
  LUEUR_TRY(with, render_candidate(session, candidate, {}));
  static_cast<void>(with);
  const uint64_t with_bytes = recorder.memory().total_bytes;
  return CandidateMemory{with_bytes - without_bytes,
                         with_bytes - bytes_of_scenes + candidate.scene->bytes};
}

}  // namespace

Result<std::vector<Candidate>> make_candidates(Session& session,
                                               std::vector<CandidateRequest> requests,
                                               const std::string& camera, uint32_t seed,
                                               const std::vector<std::string>& side_cameras,
                                               MemoryReport report) {
  Scenes scenes;
  std::vector<Candidate> candidates;
  for (CandidateRequest& request : requests) {
    LUEUR_TRY(scene, scene_named(request.scene, request.environment, request.limits, camera,
                                 side_cameras, session, scenes));
    Candidate candidate{request.label, scene, std::move(request.technique), {}, {}};
    candidate.shot = {.extent = request.size,
                      .camera = scene->cameras.main,
                      .seed = seed,
                      .side_cameras = scene->cameras.side};
    candidates.push_back(std::move(candidate));
  }
  uint64_t bytes_of_scenes = 0;
  for (const auto& scene : scenes) bytes_of_scenes += scene->bytes;
  for (Candidate& candidate : candidates) {
    if (report == MemoryReport::none) break;
    LUEUR_TRY(memory, measure_memory(session, candidate, bytes_of_scenes));
    candidate.memory = memory;
  }
  session.context.recorder().options.idle_frames = UINT64_MAX;
  return candidates;
}

Result<FrameRecord> render_candidate(Session& session, Candidate& candidate,
                                     const ImageNames& images) {
  session.context.recorder().options.history_of = candidate.label;
  return render_frame(session, *candidate.scene->renderer, candidate.shot,
                      candidate.technique.technique.get(), images);
}

std::optional<uint64_t> samples_of(const std::string& pass, const Candidate& candidate) {
  constexpr std::string_view kGather = "hierarchical.gather@";
  const ChosenTechnique& technique = candidate.technique;
  if (technique.name() != "hierarchical" || !pass.starts_with(kGather)) return std::nullopt;
  const auto& settings = *static_cast<const HierarchicalSettings*>(technique.technique->settings());
  if (settings.sampling == HierarchicalSettings::Sampling::every_pixel) return std::nullopt;
  uint32_t level = 0;
  std::from_chars(pass.data() + kGather.size(), pass.data() + pass.size(), level);
  // A pixel of level 0 covers 1, 2 or 4 of the picture's a side, one of each next level twice that.
  const uint32_t factor = 1u << (static_cast<uint32_t>(settings.start) + level);
  const Extent size = candidate.shot.extent;
  return uint64_t{divide_up(size.width, factor)} * divide_up(size.height, factor) *
         samples_at_level(settings, level);
}

}  // namespace lueur::cli
