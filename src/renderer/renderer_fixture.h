// SPDX-License-Identifier: MIT
// For the renderer's tests: small scenes of quads, rendered, and each pixel's ray to compare with.
#pragma once

#include <string>
#include <vector>

#include "renderer/renderer.h"
#include "support/gpu_test.h"

namespace lueur {

// What a test asks of one pixel.
struct PixelRay {
  uint32_t x = 0, y = 0;
  size_t index = 0;      // of the pixel, rows from the top
  glm::dvec3 origin;     // world
  glm::dvec3 direction;  // world, not unit: it advances by 1 along the optical axis
};

class RendererTest : public GpuTest {
 protected:
  // A scene with one camera (on node 0), a white rough material (0), and nothing in it.
  static Scene scene_seen_from(const glm::vec3& eye, const glm::vec3& target);
  // A parallelogram with its own node; its front side is where cross(u, v) points. UV runs from 0
  // to 1 along u and v. Returns the node.
  static int32_t add_quad(Scene& scene, const glm::vec3& corner, const glm::vec3& u,
                          const glm::vec3& v, int32_t material = 0);
  // A horizontal square around the origin that faces up.
  static int32_t add_floor(Scene& scene, float half_side, int32_t material = 0);
  // A light at `position` that shines along `direction`.
  static Light& add_light(Scene& scene, LightKind kind, float intensity, const glm::vec3& position,
                          const glm::vec3& direction = {0, -1, 0});

  // Renders and reads back all images of one frame.
  void render(const Scene& scene, const Shot& shot, Technique* technique = nullptr);
  void render(const Scene& scene) { render(scene, {.extent = kExtent}); }
  // A channel of a pixel of an image by its name in RenderedImages.
  glm::vec4 at(const std::string& image, const PixelRay& pixel) const;
  float luminance_at(const std::string& image, const PixelRay& pixel) const {
    return at(image, pixel).y;
  }
  // One ray for each pixel's centre, from the camera of the last rendering.
  std::vector<PixelRay> rays() const;

  static constexpr Extent kExtent{64, 48};

 private:
  std::vector<Pixels> images_;
  Camera camera_;
  glm::dmat4 world_from_camera_{1.0};
  Extent extent_ = kExtent;
};

// Where the ray meets the plane through `point`; none if behind the camera or along the plane.
std::optional<glm::dvec3> meet_plane(const PixelRay& ray, const glm::dvec3& point,
                                     const glm::dvec3& normal);

// One half float's rounding, whichever way it goes, and the normals' 16 bits.
inline constexpr double kHalfError = 1.0 / 1024 + 1e-4;

}  // namespace lueur
