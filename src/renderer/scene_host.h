// SPDX-License-Identifier: MIT
// What the renderer does for techniques that ask for more than the camera's G-buffer.
#pragma once

#include <vector>

#include "lueur/host.h"
#include "renderer/background.h"
#include "renderer/frame_scene.h"
#include "scene/scene.h"

namespace lueur {

// Of one frame. Views are drawn by passes named `renderer.view.…`.
class SceneHost final : public Host {
 public:
  // `world_from_node` is the pose and `of_instances` are the boxes of bounds_of_instances(), both
  // of this frame. `background` may be nullptr, and must outlive this object.
  SceneHost(FrameScene& frame_scene, const Scene& scene,
            const std::vector<glm::mat4>& world_from_node, std::span<const Bounds> of_instances,
            const Background* background);

  GBuffer render_view(Frame& frame, const View& view, Extent extent,
                      const ViewContent& content) override;
  void give_back(Frame& frame, Image image) override { frame.recorder().release(image); }
  Image background(Frame& frame, const View& view, Extent extent) override;
  // See scene/moving_objects.h.
  std::span<const MovingObject> objects() const override { return objects_; }
  // In the order of Scene::lights.
  std::span<const PunctualLight> lights() const override { return lights_; }
  Box bounds() const override { return bounds_; }
  std::span<const TriangleBatch> triangles(Frame& frame) override;

 private:
  FrameScene& scene_;
  std::vector<PunctualLight> lights_;
  Box bounds_;
  std::vector<MovingObject> objects_;
  const Background* background_;
  std::vector<TriangleBatch> batches_;  // none before somebody asks
};

}  // namespace lueur
