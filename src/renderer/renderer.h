// SPDX-License-Identifier: MIT
// The example host: a deferred renderer that calls techniques as any engine would.
//
// Each frame: G-buffer -> shadow maps -> direct light (diffuse source radiance and specular apart)
// -> technique -> composition `source + albedo * indirect + specular + indirect specular` -> the
// environment where there is no surface. Occlusion is no light: the composition leaves it alone,
// unless it is all that a technique gives. Then diffuse direct light is multiplied by it, as games
// without indirect light do, so that there is something to look at. The environment's light upon
// surfaces is indirect and left to techniques: like the light of all that glows, it is in none of
// the images of direct light.
//
// A technique gets all that lueur/technique.h offers, Host included; side views are those that the
// shot names, and `emission` is valid if any material of the scene emits.
#pragma once

#include <memory>
#include <vector>

#include "frame/recorder.h"
#include "gpu/system.h"
#include "lueur/technique.h"
#include "scene/scene.h"

namespace lueur {

// What one frame shows.
struct Shot {
  Extent extent;       // pixels
  int32_t camera = 0;  // index into Scene::cameras
  float time_s = 0;
  float previous_time_s = 0;  // of the frame before, for motion vectors
  uint32_t seed = 0;
  // Further cameras of the same instant and extent, whose views a technique gets beside its own.
  std::vector<int32_t> side_cameras{};
  // Techniques shall keep nothing of the frame before. The renderer knows by itself that a frame is
  // the first of its history (RecorderOptions::history_of), or that the last one had another camera
  // or extent; that the scene has jumped, only the program knows.
  bool cut = false;
};

// The view of the shot's camera: reversed z, infinitely far plane.
View view_of(const Scene& scene, const Shot& shot);

// All images of one frame, W x H; linear Rec.709 where they hold light (cd/m² for glTF scenes).
struct RenderedImages {
  Image depth;     // d32f, reversed z, infinitely far plane, 0 where nothing is
  Image normal;    // rg16_snorm, octahedral, world space
  Image albedo;    // rgba16f: diffuse albedo, base colour * (1 - metallic)
  Image material;  // rgba8: r metallic, g perceptual roughness, b share of dielectric F0;
                   // of surfaces with a cosine lobe, g is unused and b a part of its index
  Image emission;  // rgba16f: emitted radiance
  Image motion;    // rg16f: UV now minus UV in the previous frame
  Image source;    // rgba16f: diffuse direct radiance + emission; what the technique gets
  // rgba16f: specular direct radiance. And what an object would have as `source` that passes no
  // light on: it is seen and never gathered. To techniques, its albedo and emission are black.
  Image specular;
  Image indirect;           // rgba16f: E/pi from the technique; invalid without one
  Image indirect_specular;  // rgba16f: radiance from the technique; invalid if it gives none
  Image occlusion;          // r16f: 1 open, 0 closed, from the technique; invalid if it gives none
  Image composed;           // rgba16f: the picture, scene-referred
};

class Renderer {
 public:
  // Uploads the scene. `system` and `context` must outlive the renderer. Fails when memory runs
  // out.
  static Result<std::unique_ptr<Renderer>> create(gpu::System& system, Context& context,
                                                  const Scene& scene);
  ~Renderer();

  // Records one frame. `technique` may be nullptr: direct light only.
  RenderedImages record(Frame& frame, const Shot& shot, Technique* technique);

  // What the scene asks for that the renderer does not do, one line each.
  const std::vector<std::string>& warnings() const;

 private:
  struct State;
  explicit Renderer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace lueur
