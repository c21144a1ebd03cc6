// SPDX-License-Identifier: MIT
// Errors that only show in motion: flicker and ghosts. Both follow points from frame to frame, from
// the frames' own motion, depth and normals, and work for any sequence that has them.
#pragma once

#include <cstdint>
#include <vector>

#include "image/image.h"
#include "image/mask.h"
#include "lueur/result.h"

namespace lueur {

// What a frame's pixels show, as the layers of those names in rendered EXR files.
struct Surfaces {
  ImageF motion;  // 2 channels: UV now minus UV in the previous frame, as in lueur/view.h
  ImageF depth;   // 1 channel: distance along the optical axis in metres, 0 where nothing is
  ImageF normal;  // 3 channels: unit, world space, 0 where nothing is
};

// A pixel shows the same surface as one of the frame before when their depths differ by no more
// than this share of the present one, and their normals by no more than this cosine. A camera or
// object that covers more than that share of the distance in a frame loses its points; an object
// that moves closer than that before a wall of the same direction uncovers nothing.
inline constexpr float kSameDepth = 0.05f;
inline constexpr float kSameNormal = 0.9f;

// Flicker: with Y the luminance, p a pixel's centre and m its motion,
//
//   flicker = sum |Y_now(p) - Y_before(p - m)| / sum Y_now(p)
//
// over the points that both frames show, 0 or more, without unit. Y_before is interpolated
// bilinearly; points whose neighbours there are outside or another surface are left out.
// Light that moves changes its points, too: subtract the flicker of the reference sequence.
struct FrameChange {
  double change = 0.0;     // the sum above the line
  double luminance = 0.0;  // the one below
  uint64_t points = 0;

  // Adds the next pair of a sequence: its flicker is that of the sums.
  FrameChange& operator+=(const FrameChange& other);
  double flicker() const;  // 0 when nothing changed or no point was followed
};

// Fails (ErrorKind::input) when the images' sizes or channels are not those stated, with pictures
// of 1, 3 or 4 channels, or a picture has a NaN or infinite sample.
Result<FrameChange> frame_change(const ImageF& before, const Surfaces& surfaces_before,
                                 const ImageF& now, const Surfaces& surfaces_now);

// The pixels that a moving object, or a moving camera, uncovered: they show a surface whose place
// in the frame before lay inside the picture, but the nearest pixel there showed another surface or
// nothing. Such pixels stay known while their surface is followed through later frames. What enters
// over the picture's border is not uncovered, nor is anything in the first frame.
class UncoveredPixels {
 public:
  // Takes the next frame. Fails (ErrorKind::input) when its images' sizes or channels are not those
  // stated, or their size is not that of the frames before.
  Result<void> add(const Surfaces& frame);

  // The pixels of the latest frame whose surface was uncovered in it or in one of the `frames` - 1
  // frames before it.
  Mask within(uint32_t frames) const;

 private:
  Surfaces latest_;
  std::vector<uint32_t> age_frames_;  // since a pixel's surface was uncovered
};

// Ghosts: what a technique with a memory leaves behind moving objects. Of luminance, over the
// pixels that were uncovered lately, against the reference, or against the converged picture of the
// same standing frame.
struct Ghosting {
  double difference = 0.0;  // sum(t - r)
  double distance = 0.0;    // sum |t - r|
  double luminance = 0.0;   // sum(r)
  uint64_t pixels = 0;      // those that count; with none, all is 0

  // Adds the next frame of a sequence: its errors are those of the sums.
  Ghosting& operator+=(const Ghosting& other);
  double bias() const;   // difference / luminance: above 0 a bright trail, below 0 a dark one
  double error() const;  // distance / luminance, at least |bias|
};

// Fails (ErrorKind::input) like scene_errors(), except that the mask may leave no pixel.
Result<Ghosting> ghosting(const ImageF& test, const ImageF& reference, const Mask& uncovered);

}  // namespace lueur
