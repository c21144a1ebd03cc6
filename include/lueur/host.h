// SPDX-License-Identifier: MIT
// What a technique may ask of the engine beyond the camera's own G-buffer. All of it is optional:
// see what each technique says it needs.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>

#include "lueur/g_buffer.h"
#include "lueur/triangles.h"

namespace lueur {

class Frame;

inline constexpr int32_t kAllLights = -1;

// A light without extent, as glTF's KHR_lights_punctual has them. World space, metres, linear
// Rec.709.
struct PunctualLight {
  enum class Kind : int32_t { point, spot, directional };
  Kind kind = Kind::point;
  std::array<float, 3> position{};                    // point, spot
  std::array<float, 3> direction{0.0f, 0.0f, -1.0f};  // in which it shines, unit: spot, directional
  std::array<float, 3> intensity{};                   // cd (point, spot) or lux (directional)
  float inner_cone_rad = 0.0f;                        // half angles: spot
  float outer_cone_rad = 0.7853982f;
  float range_m = std::numeric_limits<float>::infinity();

  bool operator==(const PunctualLight&) const = default;
};

// A box in world space.
struct Box {
  std::array<float, 3> min{};
  std::array<float, 3> max{};
};

// Something that moves or changes its shape by itself. What it is in a frame is told by `bounds`,
// which ones a picture shows by GBuffer::object.
struct MovingObject {
  Box bounds;
};

// What a view shows.
struct ViewContent {
  // With a light's index, `source` holds the diffuse reflection of that light alone, without
  // emission.
  int32_t light = kAllLights;
  // Indices of Host::objects() that are left out of the picture. They still cast shadows.
  std::span<const uint32_t> without{};
  bool objects = false;  // GBuffer::object is wanted, too
};

// The engine's side. Called by techniques while they record, in the middle of a frame; what it
// records goes into the same frame.
class Host {
 public:
  virtual ~Host() = default;

  // The G-buffer of what `view` sees, `extent` pixels large; invalid images if the engine cannot.
  // `view` may stand anywhere and be off-centre, but its projection has reversed z and an infinite
  // far plane (clip z = near, clip w = -z), so that engines draw it with the state they have.
  virtual GBuffer render_view(Frame& frame, const View& view, Extent extent,
                              const ViewContent& content = {}) = 0;

  // What comes from far behind all surfaces, such as the sky's light: the radiance that `view`, as
  // above, would see if nothing were in its way. rgba16f, alpha ignored, in the unit of `source`;
  // invalid if there is none.
  virtual Image background(Frame&, const View&, Extent) { return {}; }

  // An image of the two above is not needed any more in this frame: its memory may serve others.
  virtual void give_back(Frame&, Image) {}
  void give_back_all(Frame& frame, const GBuffer& g) {
    for (const Image& image :
         {g.depth, g.normal, g.source, g.emission, g.motion, g.albedo, g.reflectance, g.object})
      if (image.valid()) give_back(frame, image);
  }

  // At most 255, always in the same order; what is in none of them stands still.
  virtual std::span<const MovingObject> objects() const { return {}; }

  virtual std::span<const PunctualLight> lights() const = 0;

  // Around all that is drawn.
  virtual Box bounds() const = 0;

  // All that casts shadows, as it is in this frame. Valid until the frame ends.
  virtual std::span<const TriangleBatch> triangles(Frame& frame) = 0;
};

}  // namespace lueur
