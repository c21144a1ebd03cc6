// SPDX-License-Identifier: MIT
#include "renderer/renderer_fixture.h"

namespace lueur {

void RendererTest::render(const Scene& scene, const Shot& shot, Technique* technique) {
  images_.clear();
  camera_ = scene.cameras[static_cast<size_t>(shot.camera)];
  extent_ = shot.extent;
  world_from_camera_ = glm::dmat4(pose(scene, shot.time_s)[static_cast<size_t>(camera_.node)]);
  auto renderer = Renderer::create(system(), context(), scene);
  ASSERT_TRUE(renderer.ok()) << renderer.error().message;
  run([&](Frame& frame) {
    const RenderedImages images = (*renderer)->record(frame, shot, technique);
    Recorder& r = frame.recorder();
    r.read_back("depth", images.depth);
    r.read_back("normal", images.normal);
    r.read_back("albedo", images.albedo);
    r.read_back("material", images.material);
    r.read_back("emission", images.emission);
    r.read_back("motion", images.motion);
    r.read_back("source", images.source);
    r.read_back("specular", images.specular);
    r.read_back("indirect", images.indirect);
    r.read_back("indirect_specular", images.indirect_specular);
    r.read_back("occlusion", images.occlusion);
    r.read_back("composed", images.composed);
  });
  images_ = recorder().read_back_pixels();
}

glm::vec4 RendererTest::at(const std::string& image, const PixelRay& pixel) const {
  for (const Pixels& p : images_) {
    if (p.name != image) continue;
    glm::vec4 value(0.0f);
    for (uint32_t c = 0; c < p.channels; ++c)
      value[static_cast<int>(c)] = p.samples[pixel.index * p.channels + c];
    return value;
  }
  ADD_FAILURE() << "there is no image " << image;
  return {};
}

std::vector<PixelRay> RendererTest::rays() const {
  return pixel_rays(camera_, world_from_camera_, extent_.width, extent_.height);
}

}  // namespace lueur
