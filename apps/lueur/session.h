// SPDX-License-Identifier: MIT
// What render and bench share: a scene, a device, and one frame of them.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "environment_choice.h"
#include "frame/recorder.h"
#include "gpu/system.h"
#include "lueur/technique.h"
#include "renderer/renderer.h"
#include "scene/gltf_load.h"
#include "scene/scene.h"

namespace lueur::cli {

struct LoadedScene {
  Scene scene;
  double load_ms = 0;
};

// Whether `spec` begins with the name of a built-in scene.
bool is_builtin(const std::string& spec);

// `spec` is the name of a built-in scene, with parameters or without, or a scene file: a path that
// ends in one of kSceneFileEndings, or that exists. A built-in name wins over a file of that name.
// Files get the camera and the light that they lack. A chosen environment takes the place of the
// scene's own.
Result<LoadedScene> load_scene(const std::string& spec, const EnvironmentChoice& environment = {},
                               const LoadLimits& limits = {});

// A camera's number or its name; the first one for "". The error lists the cameras.
Result<int32_t> find_camera(const Scene& scene, const std::string& text);

// The camera of the picture, and further ones whose views a technique gets beside it.
struct Cameras {
  int32_t main = 0;
  std::vector<int32_t> side{};
};
// As find_camera(); the side ones have to be named.
Result<Cameras> find_cameras(const Scene& scene, const std::string& main,
                             const std::vector<std::string>& side);

struct Session {
  std::unique_ptr<gpu::System> system;
  Context context;
};

// Opens the device with timers on, one frame at a time, and with the pipelines of earlier runs.
Result<Session> open_session(const gpu::SystemInfo& info);

// What came back from one frame.
struct FrameRecord {
  std::vector<PassTime> passes;       // one row a name, in order; times of equal names added up
  std::vector<Pixels> pixels;         // what was asked for and what is watched
  std::vector<ScanFinding> findings;  // of a scan, if one is on
  std::vector<std::string> written;   // "pass.image", each once
};

// Names of the renderer's images, as in RenderedImages, that are to come back with a frame.
using ImageNames = std::vector<std::string_view>;
inline const ImageNames kAllImages = {
    "composed", "depth",  "normal",   "albedo",   "material",          "emission",
    "motion",   "source", "specular", "indirect", "indirect_specular", "occlusion"};

// Records, submits and waits. Images that the frame does not have are left out.
Result<FrameRecord> render_frame(Session& session, Renderer& renderer, const Shot& shot,
                                 Technique* technique, const ImageNames& images);

// Sum of the passes whose name begins with `prefix`.
double total_ms(const std::vector<PassTime>& passes, std::string_view prefix);

}  // namespace lueur::cli
