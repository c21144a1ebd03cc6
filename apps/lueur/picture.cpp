// SPDX-License-Identifier: MIT
#include "picture.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/check.h"
#include "shading/packing.h"

namespace lueur::cli {
namespace {

ImageF sum(ImageF a, const ImageF& b) {
  for (size_t i = 0; i < a.samples.size(); ++i) a.samples[i] += b.samples[i];
  return a;
}

// Calls `write(pixel index, the pixel's samples, output samples)` for each pixel.
template <class Write>
ImageF mapped(const Pixels& pixels, uint32_t channels, Write write) {
  ImageF image(pixels.extent.width, pixels.extent.height, channels);
  const size_t count = size_t{image.width} * image.height;
  for (size_t i = 0; i < count; ++i)
    write(i, &pixels.samples[i * pixels.channels], &image.samples[i * channels]);
  return image;
}

ImageF world_normal(const Pixels& normal, const Pixels& depth) {
  return mapped(normal, 3, [&](size_t i, const float* from, float* to) {
    if (depth.samples[i] == 0.0f) return;
    const vec3 n = octahedral_decode(vec2(from[0], from[1]));
    for (int c = 0; c < 3; ++c) to[c] = n[c];
  });
}

// Reversed z with an infinitely far plane: depth = near / z.
ImageF depth_in_metres(const Pixels& depth, float near_m) {
  return mapped(depth, 1, [&](size_t, const float* from, float* to) {
    *to = *from > 0.0f ? near_m / *from : 0.0f;
  });
}

ImageF alpha(const Pixels& pixels) {
  return mapped(pixels, 1, [](size_t, const float* from, float* to) { *to = from[3]; });
}

}  // namespace

const Pixels* find_pixels(std::span<const Pixels> all, std::string_view name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Pixels& p) { return p.name == name; });
  return found == all.end() ? nullptr : &*found;
}

ImageF as_image(const Pixels& pixels, uint32_t channels) {
  LUEUR_CHECK_OP(channels, <=, pixels.channels);
  return mapped(pixels, channels,
                [&](size_t, const float* from, float* to) { std::copy_n(from, channels, to); });
}

std::vector<ImageLayer> exr_layers(std::span<const Pixels> all, float near_m,
                                   std::string_view diffuse_alpha) {
  std::vector<ImageLayer> layers;
  const auto pixels = [&](std::string_view name) { return find_pixels(all, name); };
  const auto add_as_is = [&](const char* layer, std::string_view name, uint32_t channels) {
    if (const Pixels* p = pixels(name)) layers.push_back({layer, as_image(*p, channels)});
  };
  const Pixels* source = pixels("source");
  const Pixels* specular = pixels("specular");
  const Pixels* depth = pixels("depth");

  add_as_is("", "composed", 3);
  if (source && specular)
    layers.push_back({"direct", sum(as_image(*source, 3), as_image(*specular, 3))});
  add_as_is("indirect", "indirect", 3);
  if (const Pixels* indirect = pixels("indirect"); indirect && !diffuse_alpha.empty())
    layers.push_back({std::string(diffuse_alpha), alpha(*indirect)});
  add_as_is("indirect_specular", "indirect_specular", 3);
  add_as_is("occlusion", "occlusion", 1);
  add_as_is("albedo", "albedo", 3);
  if (const Pixels* normal = pixels("normal"); normal && depth)
    layers.push_back({"normal", world_normal(*normal, *depth)});
  if (depth) layers.push_back({"depth", depth_in_metres(*depth, near_m)});
  add_as_is("specular", "specular", 3);
  add_as_is("emission", "emission", 3);
  add_as_is("source", "source", 3);
  add_as_is("motion", "motion", 2);
  add_as_is("material", "material", 3);
  return layers;
}

std::optional<double> off_screen_share(std::span<const Pixels> all,
                                       std::string_view diffuse_alpha) {
  if (diffuse_alpha != "off_screen") return std::nullopt;
  const Pixels* indirect = find_pixels(all, "indirect");
  const Pixels* depth = find_pixels(all, "depth");
  if (!indirect || !depth) return std::nullopt;
  double sum_of_shares = 0;
  size_t count = 0;
  for (size_t i = 0; i < depth->samples.size(); ++i) {
    if (depth->samples[i] == 0.0f) continue;
    sum_of_shares += static_cast<double>(indirect->samples[i * indirect->channels + 3]);
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum_of_shares / static_cast<double>(count);
}

}  // namespace lueur::cli
