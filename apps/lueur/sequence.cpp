// SPDX-License-Identifier: MIT
#include "sequence.h"

#include <utility>

#include "base/check.h"
#include "base/try.h"
#include "console.h"
#include "picture.h"

namespace lueur::cli {
namespace {

// E/pi of the technique; black without one.
ImageF indirect_of(std::span<const Pixels> pixels, Extent size) {
  const Pixels* indirect = find_pixels(pixels, "indirect");
  return indirect ? as_image(*indirect, 3) : ImageF(size.width, size.height, 3);
}

Surfaces surfaces_of(std::span<const Pixels> pixels, float near_m) {
  Surfaces surfaces;
  for (ImageLayer& layer : exr_layers(pixels, near_m, {})) {
    if (layer.name == "motion") surfaces.motion = std::move(layer.image);
    if (layer.name == "depth") surfaces.depth = std::move(layer.image);
    if (layer.name == "normal") surfaces.normal = std::move(layer.image);
  }
  return surfaces;
}

// What is kept of a frame until the next one.
struct Kept {
  ImageF indirect;
  ImageF converged;
  Surfaces surfaces;
};

// The frames of one technique: moving with one instance and history, standing with another.
class Renderings {
 public:
  Renderings(Session& session, Renderer& renderer, const Cameras& cameras, const Sequence& sequence,
             const ChosenTechnique& technique)
      : session_(session),
        renderer_(renderer),
        cameras_(cameras),
        sequence_(sequence),
        moving_(copy(technique)),
        standing_(copy(technique)) {}

  Result<std::vector<Pixels>> moving(int32_t frame) {
    LUEUR_TRY(
        record,
        render(moving_.label, moving_shot(sequence_.pace, sequence_.setup, cameras_, frame),
               moving_.technique.get(), {"composed", "indirect", "depth", "normal", "motion"}));
    return std::move(record.pixels);
  }

  // The mean of renderings of one instant.
  Result<ImageF> converged(int32_t frame) {
    const Extent size = sequence_.setup.size;
    ImageF mean(size.width, size.height, 3);
    if (!standing_.technique) return mean;
    const std::string history = standing_.label + " standing";  // no label has a space
    // A frame without the technique ends its history: nothing is left of the instant before.
    LUEUR_TRY_VOID(render(history, standing_shot(sequence_, cameras_, frame, 0), nullptr, {}));
    for (uint32_t i = 0; i < sequence_.settle + sequence_.average; ++i) {
      const bool counts = i >= sequence_.settle;
      LUEUR_TRY(record,
                render(history, standing_shot(sequence_, cameras_, frame, i),
                       standing_.technique.get(), counts ? ImageNames{"indirect"} : ImageNames{}));
      if (counts) add_share(indirect_of(record.pixels, size), mean);
    }
    return mean;
  }

 private:
  Result<FrameRecord> render(const std::string& history, const Shot& shot, Technique* technique,
                             const ImageNames& images) {
    session_.context.recorder().options.history_of = history;
    return render_frame(session_, renderer_, shot, technique, images);
  }
  void add_share(const ImageF& light, ImageF& mean) const {
    const float share = 1.0f / static_cast<float>(sequence_.average);
    for (size_t i = 0; i < mean.samples.size(); ++i) mean.samples[i] += share * light.samples[i];
  }

  Session& session_;
  Renderer& renderer_;
  const Cameras& cameras_;
  const Sequence& sequence_;
  ChosenTechnique moving_;
  ChosenTechnique standing_;
};

Result<void> add_pair(const Kept& before, const Kept& now, SequenceErrors& errors) {
  LUEUR_TRY(change, frame_change(before.indirect, before.surfaces, now.indirect, now.surfaces));
  LUEUR_TRY(moved, frame_change(before.converged, before.surfaces, now.converged, now.surfaces));
  errors.change += change;
  errors.reference_change += moved;
  return {};
}

}  // namespace

Shot standing_shot(const Sequence& sequence, const Cameras& cameras, int32_t frame, uint32_t i) {
  return {.extent = sequence.setup.size,
          .camera = cameras.main,
          .time_s = time_of(sequence.pace, frame),
          .previous_time_s = time_of(sequence.pace, frame),
          .seed = sequence.setup.seed + i,
          .side_cameras = cameras.side};
}

std::string file_stem(const std::string& label) {
  constexpr std::string_view kSafe =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789.-=_";
  std::string stem = label;
  for (char& c : stem)
    if (kSafe.find(c) == std::string_view::npos) c = '_';
  return stem;
}

Result<SequenceErrors> measure_sequence(Session& session, Renderer& renderer, const Scene& scene,
                                        const Cameras& cameras, const Sequence& sequence,
                                        const ChosenTechnique& technique, const TakeFrame& take) {
  const float near_m = scene.cameras[static_cast<size_t>(cameras.main)].near_m;
  Renderings renderings(session, renderer, cameras, sequence, technique);
  UncoveredPixels uncovered;
  SequenceErrors errors;
  Kept before;
  for (int32_t frame = -static_cast<int32_t>(sequence.settle);
       frame < static_cast<int32_t>(sequence.frames); ++frame) {
    LUEUR_TRY(pixels, renderings.moving(frame));
    Kept now{indirect_of(pixels, sequence.setup.size), {}, surfaces_of(pixels, near_m)};
    LUEUR_TRY_VOID(uncovered.add(now.surfaces));
    if (frame < 0) continue;
    print_progress(technique.label + ": frame " + std::to_string(frame + 1) + " of " +
                   std::to_string(sequence.frames));
    LUEUR_TRY_VOID(take(static_cast<uint32_t>(frame), pixels));
    LUEUR_TRY(converged, renderings.converged(frame));
    now.converged = std::move(converged);
    if (frame > 0) LUEUR_TRY_VOID(add_pair(before, now, errors));
    LUEUR_TRY(ghosts, ghosting(now.indirect, now.converged, uncovered.within(sequence.uncovered)));
    errors.ghosts += ghosts;
    before = std::move(now);
  }
  return errors;
}

}  // namespace lueur::cli
