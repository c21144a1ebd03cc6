// SPDX-License-Identifier: MIT
#include "renderer/background.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "base/try.h"
#include "frame/screen_of_view.h"
#include "image/half.h"
#include "renderer/params.h"
#include "renderer/shaders.h"
#include "renderer/upload.h"

namespace lueur {
namespace {

constexpr uint32_t kMaxSide = 8192;

// RGBA in half floats.
std::vector<uint8_t> texels_of(const EnvironmentLevel& level) {
  std::vector<uint16_t> halves;
  halves.reserve(level.rgb.size() / 3 * 4);
  for (size_t i = 0; i < level.rgb.size(); i += 3) {
    for (size_t c = 0; c < 3; ++c)
      halves.push_back(half_from_float(std::min(level.rgb[i + c], kLargestHalf)));
    halves.push_back(half_from_float(1.0f));
  }
  const auto* bytes = reinterpret_cast<const uint8_t*>(halves.data());
  return {bytes, bytes + halves.size() * sizeof(uint16_t)};
}

}  // namespace

Result<Background> Background::create(gpu::System& system, Context& context,
                                      const Environment& environment) {
  Background background;
  EnvironmentLevel level = environment_level(environment, 0);
  while (std::max(level.width, level.height) > kMaxSide) {
    level = halved(level);
    ++background.first_level_;
  }
  const uint32_t count = environment_level_count(environment) - background.first_level_;
  std::vector<std::vector<uint8_t>> texels;
  std::vector<Extent> extents;
  for (uint32_t i = 0; i < count; ++i) {
    texels.push_back(texels_of(level));
    extents.push_back({level.width, level.height});
    if (i + 1 < count) level = halved(level);
  }
  gpu::Device& device = context.recorder().device();
  LUEUR_TRY(texture, gpu::Texture::create(device, {.name = "environment",
                                                   .extent = extents[0],
                                                   .format = Format::rgba16f,
                                                   .usage = VK_IMAGE_USAGE_SAMPLED_BIT |
                                                            VK_IMAGE_USAGE_TRANSFER_DST_BIT,
                                                   .mip_levels = count}));
  background.texture_ = std::move(texture);
  Uploader uploader(system, device);
  const std::vector<std::span<const uint8_t>> levels(texels.begin(), texels.end());
  LUEUR_TRY_VOID(uploader.to_texture(levels, extents, background.texture_));
  LUEUR_TRY_VOID(uploader.flush());
  background.environment_ = {.width = environment.width,
                             .height = environment.height,
                             .rotation_rad = environment.rotation_rad,
                             .intensity = environment.intensity};
  return background;
}

void Background::record(Recorder& frame, const View& view, Image depth, Image composed) const {
  show(frame, "renderer.background", view, {"depth", depth}, composed);
}

Image Background::alone(Recorder& frame, const View& view, Extent extent) const {
  const Image image = frame.image("background", extent, Format::rgba16f);
  // Nothing reads the depth; something has to be bound.
  show(frame, "renderer.view.background", view, {"depth", SampledTexture{&texture_}}, image);
  return image;
}

void Background::show(Recorder& frame, const std::string& pass, const View& view,
                      const Bound& depth, Image shown) const {
  // A pixel's direction in the picture's own space is corner + x step_x + y step_y.
  const glm::mat3 world_from_view =
      glm::inverse(glm::mat3(glm::make_mat4(view.view_from_world.data())));
  const glm::mat3 axes = environment_from_world(environment_) * world_from_view;
  const Screen screen = screen_of_view(view, shown.extent);
  const uint32_t level = background_level(environment_, std::abs(screen.ray_scale.y));
  BackgroundParams params{};
  params.extent = as_ivec2(shown.extent);
  params.everywhere = std::holds_alternative<Image>(depth.resource) ? 0 : 1;
  params.step_x = screen.ray_scale.x * axes[0];
  params.step_y = screen.ray_scale.y * axes[1];
  params.corner = screen.ray_offset.x * axes[0] + screen.ray_offset.y * axes[1] - axes[2];
  params.level = static_cast<float>(std::max(level, first_level_) - first_level_);
  params.intensity = environment_.intensity;
  const gpu::SamplerState sampler{.filter = gpu::Filter::linear,
                                  .u = gpu::Address::repeat,
                                  .v = gpu::Address::clamp_to_edge,
                                  .mipmaps = true};
  frame.dispatch(pass, {.shader = shaders::renderer_background_comp,
                        .params = params,
                        .read = {depth, {"environment", SampledTexture{&texture_}, sampler}},
                        .write = {{"shown", shown}},
                        .over = shown.extent});
}

}  // namespace lueur
