// SPDX-License-Identifier: MIT
// Consecutive frames of a scene's animation, rendered as an application would, and their errors
// that only show in motion.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "frame_options.h"
#include "image/sequence_error.h"
#include "moving_shot.h"
#include "session.h"
#include "technique_list.h"

namespace lueur::cli {

struct Sequence {
  FrameSetup setup;
  Pace pace;
  uint32_t frames = 16;
  // Frames before the first that counts, from which on a technique's memory is full: of the
  // animation before frame 0, and of a standing instant before its mean.
  uint32_t settle = 8;
  uint32_t average = 16;   // renderings in the mean that is a standing frame's converged picture
  uint32_t uncovered = 8;  // frames for which a pixel counts as uncovered lately
};

// Rendering `i` of the same instant standing still. Its seeds are the same for every frame, so that
// the means of two frames share what is left of their noise and differ by the light that moved.
Shot standing_shot(const Sequence& sequence, const Cameras& cameras, int32_t frame, uint32_t i);

// `label` as the beginning of a file's name: what is no letter, digit, '.', '-', '=' or '_' of
// ASCII becomes '_'.
std::string file_stem(const std::string& label);

struct SequenceErrors {
  FrameChange change;            // of the indirect light, E/pi
  FrameChange reference_change;  // of the converged standing frames
  Ghosting ghosts;               // against those, over the pixels uncovered lately

  double excess() const { return change.flicker() - reference_change.flicker(); }
};

// Takes a frame from 0 on and its images, of which `composed` is there; called in order.
using TakeFrame = std::function<Result<void>(uint32_t frame, std::span<const Pixels> pixels)>;

// Renders the sequence with one technique. The moving frames have a history of their own, and so
// have the standing ones, which start from nothing at every instant.
Result<SequenceErrors> measure_sequence(Session& session, Renderer& renderer, const Scene& scene,
                                        const Cameras& cameras, const Sequence& sequence,
                                        const ChosenTechnique& technique, const TakeFrame& take);

}  // namespace lueur::cli
