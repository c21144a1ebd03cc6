// SPDX-License-Identifier: MIT
// What the passes of one frame share, whichever view they show: the scene as it is in this frame,
// on the device, and its lights with their shadow maps.
#pragma once

#include <span>
#include <vector>

#include "frame/recorder.h"
#include "renderer/light_view.h"
#include "renderer/scene_on_device.h"

namespace lueur {

class FrameScene {
 public:
  // Uploads the frame's buffers. `kept_shadow_bytes`: how much memory shadow maps may hold until
  // the frame's end, for further views; a map beyond that is drawn again when it is asked for
  // again.
  FrameScene(Recorder& frame, const SceneOnDevice& on_device, FrameGeometry geometry,
             std::vector<LightView> lights, uint64_t kept_shadow_bytes);

  Recorder& frame() const { return frame_; }
  const SceneOnDevice& on_device() const { return on_device_; }
  const FrameGeometry& geometry() const { return geometry_; }
  const std::vector<LightView>& lights() const { return lights_; }
  BufferRef deformed() const { return deformed_; }

  // What the shaders of all draws read.
  std::vector<Bound> buffers() const;
  // The scene's LobeData.
  BufferRef lobes() const { return lobes_; }
  // Draws every item, changing state only where it changes, but for the instances of the moving
  // objects `without`. `cull`: the backs of one-sided materials.
  void draw_all(DrawList& list, bool cull, std::span<const uint32_t> without = {}) const;

  // Drawn by the first who asks. Give it back after use.
  Image shadow_map(size_t light);
  void give_back_shadow_map(size_t light);

 private:
  Image draw_shadow_map(const LightView& light);

  Recorder& frame_;
  const SceneOnDevice& on_device_;
  FrameGeometry geometry_;
  std::vector<LightView> lights_;
  std::vector<Image> shadow_maps_;  // by light; invalid: not drawn
  std::vector<bool> kept_;          // by light: its map lasts until the frame's end
  uint64_t bytes_to_keep_ = 0;      // that are left
  BufferRef instances_;
  BufferRef deformed_;
  BufferRef materials_;
  BufferRef lobes_;
};

}  // namespace lueur
