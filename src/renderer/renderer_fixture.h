// SPDX-License-Identifier: MIT
// For the renderer's tests: scenes rendered, and each pixel's ray to compare with.
#pragma once

#include <string>
#include <vector>

#include "renderer/renderer.h"
#include "support/gpu_test.h"
#include "support/test_scene.h"

namespace lueur {

class RendererTest : public GpuTest {
 protected:
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

// One half float's rounding, whichever way it goes, and the normals' 16 bits.
inline constexpr double kHalfError = 1.0 / 1024 + 1e-4;

}  // namespace lueur
