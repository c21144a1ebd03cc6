// SPDX-License-Identifier: MIT
// Ground truth on the CPU: what the indirect light of a view is, computed without hurry, to hold
// every technique against.
//
// Rays go through the pixels' centres, as a rasterizer's do, so that a pixel of the reference and
// of a technique are one point of the scene. Cameras, materials, textures and light units are the
// renderer's: linear Rec.709, cd/m² for glTF scenes. For camera rays, back faces of one-sided
// materials are not there; for light every surface is opaque and two-sided, as it is for the shadow
// maps. What is no surface is the scene's environment, or black without one. The environment is a
// far surface that emits: its light upon surfaces is indirect, as that of all that glows.
//
// The light at a point x that the camera sees, from directions w over the hemisphere around its
// normal n, all but what comes straight from punctual lights:
//
//   diffuse(x)  = 1/pi  integral of L(x, w) cos(n, w) dw                  E/pi, before albedo
//   specular(x) =       integral of f_s(x, w, eye) L(x, w) cos(n, w) dw
//
// L(x, w) is the radiance that arrives from the surface point y that x sees along w:
//
//   path                y's emission and what y reflects, by its whole BRDF, of punctual
//                       lights and, with more than one bounce, of other surfaces: bounces - 1
//                       further ones; the environment's radiance where there is no y
//   screen              y's emission and diffuse reflection, of as many bounces, if the camera sees
//                       y and each further surface, else 0: the most that a technique can know from
//                       one view's G-buffer
//   screen_unoccluded   no rays: the sum over all pixels j of HSSIL (4), or (3), with visibility 1:
//                       diffuse = sum of L_j F(x, j)
//                       Neither of these two gets light of the environment: a G-buffer has none.
//   lights              SOL 3.2 (Cochran, Steele 2007): `spp` rays share out the flux of the
//                       punctual lights; where they arrive are patches of area A = Omega d^2 /
//                       cos(theta_i), whose diffuse reflection L is summed where no shadow ray is
//                       blocked:  diffuse = sum of L A cos(theta') cos(theta) / (pi (r^2 + A/pi)
//                       r^2)
//   lights_unoccluded   the same through everything
//   ambient             no light: occlusion(x), the cosine-weighted share of directions that are
//                       free for `ambient_distance_m`, 1 = open
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>
#include <string_view>
#include <vector>

#include "image/image.h"
#include "lueur/result.h"
#include "scene/scene.h"

namespace lueur::reference {

enum class Mode : uint8_t { path, screen, screen_unoccluded, ambient, lights, lights_unoccluded };

struct ModeName {
  std::string_view name;  // as on the command line
  Mode mode;
  std::string_view summary;
};
std::span<const ModeName> mode_names();
std::string_view name_of(Mode mode);

enum class FormFactor : uint8_t { disc, point };  // HSSIL (4) and (3)

inline constexpr uint32_t kMaxBounces = 64;
inline constexpr uint32_t kLights = 300;  // rays of `lights` in lists that do not say more
inline constexpr uint32_t kMaxSpp = 1u << 20;
// A pass is what a rendering can stop after. Few samples, to stop soon; enough that looking at the
// first surface anew in each costs little.
inline constexpr uint32_t kSamplesPerPass = 16;

struct Settings {
  Mode mode = Mode::path;
  uint32_t bounces = 1;  // path, screen: 1 … kMaxBounces surfaces between a light and x
  // Samples a pixel takes, rounded up to whole passes of kSamplesPerPass. Of screen_unoccluded:
  // pixels that are summed, drawn evenly from those that have light; 0, or more than there are, is
  // every one. Of lights: how many rays they send.
  uint32_t spp = 256;
  // Above 0: stop before `spp` once the estimated relative error is at most this; see Progress.
  double target_error = 0;
  uint32_t seed = 0;
  float ambient_distance_m = 1.0f;  // ambient
  // screen_unoccluded; of lights, `point` leaves A/pi beside r^2 away.
  FormFactor form_factor = FormFactor::disc;
};

// What is looked at. `camera` is an index into Scene::cameras.
struct Shot {
  uint32_t width = 0;   // pixels
  uint32_t height = 0;  // pixels
  int32_t camera = 0;
  float time_s = 0;
};

// How far a rendering is. The relative error is that of the whole picture: the root of the mean
// variance of a pixel's mean, over the mean, of the luminance of `diffuse` (of occlusion in
// ambient). The variance comes from how passes differ; samples within a pass are stratified against
// each other and passes too, so the true error is less. Infinite before the second pass.
struct Progress {
  uint32_t spp_done = 0;
  uint32_t spp_total = 0;
  double relative_error = 0;
  double seconds = 0;       // since render() was called
  double seconds_left = 0;  // at the pace so far
  uint64_t rays = 0;        // traced since render() was called
};

struct Control {
  uint32_t threads = 0;                           // 0: as many as the machine has
  std::function<void(const Progress&)> progress;  // called after each pass, by the calling thread
  std::stop_token stop;                           // asks for an early end; see Rendering::complete
  // Gets Rendering::state about every `checkpoint_s` seconds, between passes, by the calling
  // thread.
  std::function<void(const std::vector<uint8_t>& state)> checkpoint;
  double checkpoint_s = 60;
};

// Everything that is known after some whole passes. The same scene, shot, settings and number of
// passes give the same bits, whatever the number of threads and however often it was interrupted.
struct Rendering {
  Progress progress;
  bool complete = false;  // false: stopped early, and `state` continues it
  // Layers as in EXR files of the renderer, W x H:
  //   ""         the picture: source + direct specular + albedo * indirect + indirect_specular;
  //              the environment where there is no surface
  //   direct     source + direct specular
  //   indirect   `diffuse` above                       (all but ambient)
  //   indirect_specular  `specular` above              (path)
  //   occlusion  one channel; there are no "" and indirect then       (ambient)
  //   variance   of the mean of a pixel's `diffuse`, a channel each   (path, screen, ambient)
  //   albedo, normal (unit, world), depth (metres along the axis, 0: nothing), specular (direct),
  //   emission, source
  std::vector<ImageLayer> layers;
  std::vector<uint8_t> state;
};

const ImageF* find_layer(const Rendering& rendering, std::string_view name);

// Renders `shot`. `resume_from` is the state of an earlier rendering of the same scene, shot and
// settings; fails (ErrorKind::input) when it is of another one or damaged. Fails with
// ErrorKind::memory when the scene's triangles do not fit.
Result<Rendering> render(const Scene& scene, const Shot& shot, const Settings& settings,
                         const Control& control = {}, std::span<const uint8_t> resume_from = {});

}  // namespace lueur::reference
