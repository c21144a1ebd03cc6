// SPDX-License-Identifier: MIT
#include "image/sequence_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "base/try.h"
#include "image/exposure.h"
#include "image/picture_error.h"
#include "image/sample_error.h"

namespace lueur {
namespace {

constexpr uint32_t kNeverUncovered = std::numeric_limits<uint32_t>::max();

Result<void> check_image(const ImageF& image, const char* name, const ImageF& size,
                         uint32_t channels) {
  if (image.width == size.width && image.height == size.height && image.channels == channels)
    return {};
  const auto text = [](uint32_t width, uint32_t height, uint32_t count) {
    return std::to_string(width) + "x" + std::to_string(height) + " with " + std::to_string(count) +
           " channels";
  };
  return Error{ErrorKind::input, std::string(name) + " is " +
                                     text(image.width, image.height, image.channels) +
                                     ", but has to be " + text(size.width, size.height, channels)};
}

Result<void> check_surfaces(const Surfaces& surfaces, const ImageF& size) {
  LUEUR_TRY_VOID(check_image(surfaces.motion, "motion", size, 2));
  LUEUR_TRY_VOID(check_image(surfaces.depth, "depth", size, 1));
  return check_image(surfaces.normal, "normal", size, 3);
}

bool same_surface(const Surfaces& now, size_t here, const Surfaces& before, size_t there) {
  const float z_now = now.depth.samples[here];
  const float z_before = before.depth.samples[there];
  if (!(z_before > 0.0f) || !(std::abs(z_before - z_now) <= kSameDepth * z_now)) return false;
  float cosine = 0.0f;
  for (size_t c = 0; c < 3; ++c)
    cosine += now.normal.samples[3 * here + c] * before.normal.samples[3 * there + c];
  return cosine >= kSameNormal;
}

// Where a pixel's surface was in the frame before, in pixels, relative to pixel centres.
struct Place {
  float x = 0.0f, y = 0.0f;
};

Place place_before(const ImageF& motion, uint32_t x, uint32_t y) {
  const auto width = static_cast<float>(motion.width);
  const auto height = static_cast<float>(motion.height);
  // Motion of whole pixels is not stored exactly: 1/1024 of a pixel is rounding, not a place
  // between two pixels.
  const auto snapped = [](float value) {
    const float whole = std::round(value);
    return std::abs(value - whole) < 1.0f / 1024.0f ? whole : value;
  };
  return {snapped(static_cast<float>(x) - motion.at(x, y, 0) * width),
          snapped(static_cast<float>(y) - motion.at(x, y, 1) * height)};
}

// NaN is outside.
bool is_inside(const Place& place, const ImageF& image) {
  return place.x >= 0.0f && place.x <= static_cast<float>(image.width - 1) && place.y >= 0.0f &&
         place.y <= static_cast<float>(image.height - 1);
}

size_t nearest(const Place& place, const ImageF& image) {
  return static_cast<size_t>(std::lround(place.y)) * image.width +
         static_cast<size_t>(std::lround(place.x));
}

// The pixels around a place and their bilinear weights; those of weight 0 repeat the first.
struct Neighbours {
  std::array<size_t, 4> pixel;
  std::array<float, 4> weight;
};

Neighbours neighbours_of(const Place& place, const ImageF& image) {
  const auto left = static_cast<size_t>(place.x);
  const auto top = static_cast<size_t>(place.y);
  const float u = place.x - static_cast<float>(left);
  const float v = place.y - static_cast<float>(top);
  const size_t first = top * image.width + left;
  const size_t right = u > 0.0f ? 1 : 0;
  const size_t below = v > 0.0f ? image.width : 0;
  return {{first, first + right, first + below, first + right + below},
          {(1.0f - u) * (1.0f - v), u * (1.0f - v), (1.0f - u) * v, u * v}};
}

}  // namespace

FrameChange& FrameChange::operator+=(const FrameChange& other) {
  change += other.change;
  luminance += other.luminance;
  points += other.points;
  return *this;
}

double FrameChange::flicker() const {
  return relative(change, luminance);
}

Ghosting& Ghosting::operator+=(const Ghosting& other) {
  difference += other.difference;
  distance += other.distance;
  luminance += other.luminance;
  pixels += other.pixels;
  return *this;
}

double Ghosting::bias() const {
  return relative(difference, luminance);
}

double Ghosting::error() const {
  return relative(distance, luminance);
}

Result<FrameChange> frame_change(const ImageF& before, const Surfaces& surfaces_before,
                                 const ImageF& now, const Surfaces& surfaces_now) {
  LUEUR_TRY_VOID(check_comparable(before, now));
  LUEUR_TRY_VOID(check_surfaces(surfaces_before, now));
  LUEUR_TRY_VOID(check_surfaces(surfaces_now, now));
  FrameChange sum;
  for (uint32_t y = 0; y < now.height; ++y)
    for (uint32_t x = 0; x < now.width; ++x) {
      const size_t here = size_t{y} * now.width + x;
      const Place place = place_before(surfaces_now.motion, x, y);
      if (!(surfaces_now.depth.samples[here] > 0.0f) || !is_inside(place, now)) continue;
      const Neighbours neighbours = neighbours_of(place, now);
      const bool followed = std::ranges::all_of(neighbours.pixel, [&](size_t there) {
        return same_surface(surfaces_now, here, surfaces_before, there);
      });
      if (!followed) continue;
      double y_before = 0.0;
      for (size_t i = 0; i < 4; ++i)
        y_before += static_cast<double>(neighbours.weight[i]) *
                    static_cast<double>(luminance_at(before, neighbours.pixel[i]));
      const auto y_now = static_cast<double>(luminance_at(now, here));
      sum.change += std::abs(y_now - y_before);
      sum.luminance += y_now;
      ++sum.points;
    }
  return sum;
}

Result<void> UncoveredPixels::add(const Surfaces& frame) {
  const bool is_first = age_frames_.empty();
  LUEUR_TRY_VOID(check_surfaces(frame, is_first ? frame.depth : latest_.depth));
  std::vector<uint32_t> age_frames(frame.depth.samples.size(), kNeverUncovered);
  for (uint32_t y = 0; y < frame.depth.height && !is_first; ++y)
    for (uint32_t x = 0; x < frame.depth.width; ++x) {
      const size_t here = size_t{y} * frame.depth.width + x;
      const Place place = place_before(frame.motion, x, y);
      if (!(frame.depth.samples[here] > 0.0f) || !is_inside(place, frame.depth)) continue;
      const size_t there = nearest(place, frame.depth);
      if (!same_surface(frame, here, latest_, there))
        age_frames[here] = 0;
      else if (age_frames_[there] != kNeverUncovered)
        age_frames[here] = age_frames_[there] + 1;
    }
  latest_ = frame;
  age_frames_ = std::move(age_frames);
  return {};
}

Mask UncoveredPixels::within(uint32_t frames) const {
  Mask mask{latest_.depth.width, latest_.depth.height, {}};
  mask.counts.reserve(age_frames_.size());
  for (const uint32_t age : age_frames_) mask.counts.push_back(age < frames ? 1 : 0);
  return mask;
}

Result<Ghosting> ghosting(const ImageF& test, const ImageF& reference, const Mask& uncovered) {
  LUEUR_TRY_VOID(check_comparable(test, reference));
  if (uncovered.width != test.width || uncovered.height != test.height)
    return Error{ErrorKind::input, "the mask of uncovered pixels and the pictures differ in size"};
  Ghosting sum;
  for (size_t i = 0; i < uncovered.counts.size(); ++i) {
    if (!counts(&uncovered, i)) continue;
    const auto t = static_cast<double>(luminance_at(test, i));
    const auto r = static_cast<double>(luminance_at(reference, i));
    sum.difference += t - r;
    sum.distance += std::abs(t - r);
    sum.luminance += r;
    ++sum.pixels;
  }
  return sum;
}

}  // namespace lueur
