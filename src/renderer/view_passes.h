// SPDX-License-Identifier: MIT
// The passes that show one view of the scene up to its direct light: G-buffer -> surface -> each
// light. The frame's camera goes through them, and each view that a technique asks for.
#pragma once

#include <span>
#include <string>

#include "renderer/frame_scene.h"
#include "renderer/renderer.h"

namespace lueur {

class ViewPasses {
 public:
  // Passes are called `name`.g_buffer and so on. `view_before` is what motion leads to.
  ViewPasses(FrameScene& scene, std::string name, Extent extent, const View& view,
             const View& view_before);

  // G-buffer and surface, but for the moving objects `without`. Without `emission`, nothing glows.
  void show_surfaces(bool emission, std::span<const uint32_t> without = {});
  // Adds one light's direct light.
  void add_light(size_t light);
  // What a technique gets. Before release_surfaces().
  GBuffer g_buffer(bool objects);
  // What is neither in images() nor in g_buffer().
  void release_surfaces();
  // And all that are not `given`: for views that nobody else looks at.
  void release_all_but(const GBuffer& given);

  // As far as they are made: all but what comes from a technique.
  const RenderedImages& images() const { return images_; }

 private:
  void draw_g_buffer(std::span<const uint32_t> without);
  bool gives_emission() const;
  void pass_on(GBuffer& g);
  Image object_image();

  FrameScene& scene_;
  Recorder& frame_;
  std::string name_;
  Extent extent_;
  View view_;
  View view_before_;
  bool emission_ = true;
  RenderedImages images_{};
  Image base_color_{};  // rgba8_srgb; alpha: InstanceData::object in 255ths
};

}  // namespace lueur
