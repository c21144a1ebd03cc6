// SPDX-License-Identifier: MIT
#include "render_frames.h"

#include <memory>

#include "base/try.h"
#include "console.h"
#include "picture.h"
#include "render_output.h"
#include "statistics.h"
#include "timing.h"
#include "video.h"
#include "view_picture.h"

namespace lueur::cli {
namespace {

// Times of all frames, to take medians of.
class Times {
 public:
  void add(const std::vector<PassTime>& passes) { frames_.push_back(passes); }

  // Of what `ms_of` takes from a frame's passes.
  template <class MsOf>
  double median_ms(MsOf ms_of) const {
    std::vector<double> all;
    for (const std::vector<PassTime>& passes : frames_) all.push_back(ms_of(passes));
    return all.empty() ? 0.0 : distribution(std::move(all)).median;
  }
  // Of each pass over the frames that have it, in the order of the first frame.
  std::vector<PassTime> median_passes() const {
    std::vector<PassTime> medians;
    if (frames_.empty()) return medians;
    for (const PassTime& pass : frames_.front()) {
      std::vector<double> all;
      for (const std::vector<PassTime>& passes : frames_)
        for (const PassTime& other : passes)
          if (other.name == pass.name) all.push_back(other.gpu_ms);
      medians.push_back({pass.name, distribution(std::move(all)).median});
    }
    return medians;
  }

 private:
  std::vector<std::vector<PassTime>> frames_;
};

// Where the frames go.
class FrameFiles {
 public:
  explicit FrameFiles(const RenderJob& job) : job_(job) {}

  Result<void> add(uint32_t frame, const FrameRecord& record, const Development& development,
                   std::vector<std::string>& written) {
    std::vector<Destination> pictures;
    for (const std::string& name : job_.frame_outputs.pictures)
      pictures.push_back(destination_of(name_of_frame(name, frame)));
    LUEUR_TRY_VOID(write_frame(job_.view, pictures, record, development));
    for (const Destination& picture : pictures) {
      written.push_back(picture.path.string());
      print_progress("wrote " + written.back());
    }
    if (job_.frame_outputs.videos.empty()) return {};
    LUEUR_TRY(picture, shown(job_.view, record, development));
    for (size_t i = 0; i < job_.frame_outputs.videos.size(); ++i) {
      if (videos_.size() == i) {
        LUEUR_TRY(video, VideoFile::open(job_.frame_outputs.videos[i],
                                         {picture.width, picture.height}, job_.pace.rate));
        videos_.push_back(std::move(video));
      }
      LUEUR_TRY_VOID(videos_[i]->add(picture));
    }
    return {};
  }

  Result<void> finish(std::vector<std::string>& written) {
    for (size_t i = 0; i < videos_.size(); ++i) {
      LUEUR_TRY_VOID(videos_[i]->finish());
      written.push_back(job_.frame_outputs.videos[i].string());
      print_progress("wrote " + written.back());
    }
    return {};
  }

 private:
  const RenderJob& job_;
  std::vector<std::unique_ptr<VideoFile>> videos_;  // none before the first frame
};

ImageNames images_of(const RenderJob& job) {
  for (const std::string& name : job.frame_outputs.pictures)
    if (destination_of(name).kind == FileKind::exr && job.view.empty()) return kAllImages;
  return {"composed"};
}

void add_findings(int32_t frame, std::vector<ScanFinding> findings, RenderReport& report) {
  for (ScanFinding& finding : findings) {
    finding.image = "frame " + std::to_string(frame) + ": " + finding.image;
    report.findings.push_back(std::move(finding));
  }
}

}  // namespace

Result<void> render_frames(const RenderJob& job, Session& session, Renderer& renderer,
                           const Scene& scene, const Cameras& cameras, const std::stop_token& stop,
                           RenderReport& report) {
  const auto first = static_cast<int32_t>(job.frames->first);
  const auto last = static_cast<int32_t>(job.frames->last);
  const ImageNames images = images_of(job);
  RecorderOptions& inspect = session.context.recorder().options;
  inspect.scan = job.scan;
  if (!job.view.empty()) inspect.watch = {job.view};
  Development development{.tone_map = job.tone_map,
                          .near_m = scene.cameras[static_cast<size_t>(cameras.main)].near_m,
                          .diffuse_alpha = job.technique.diffuse_alpha(),
                          .attributes = {}};
  FrameFiles files(job);
  Times times;
  report.frames = 0;
  for (int32_t frame = first - static_cast<int32_t>(job.settle); frame <= last; ++frame) {
    if (stop.stop_requested()) break;
    const bool counts = frame >= first;
    print_progress(counts ? "frame " + std::to_string(frame) + " of " + std::to_string(first) +
                                " to " + std::to_string(last)
                          : "settling");
    const Shot shot = moving_shot(job.pace, job.setup, cameras, frame);
    LUEUR_TRY(record, render_frame(session, renderer, shot, job.technique.technique.get(),
                                   counts ? images : ImageNames{}));
    add_findings(frame, std::move(record.findings), report);
    if (!counts) continue;
    times.add(record.passes);
    // What the first frame is exposed by holds for all, or the pictures would pump.
    if (frame == first)
      report.exposure_ev = exposure_ev(job.exposure, scene.exposure_ev,
                                       as_image(*find_pixels(record.pixels, "composed"), 3));
    development.exposure_ev = report.exposure_ev;
    development.attributes = attributes(job, report, shot);
    LUEUR_TRY_VOID(files.add(static_cast<uint32_t>(frame), record, development, report.outputs));
    ++*report.frames;
  }
  report.passes = times.median_passes();
  report.technique_ms =
      times.median_ms([&](const auto& passes) { return technique_ms(passes, job.technique); });
  report.host_ms =
      times.median_ms([&](const auto& passes) { return host_ms(passes, job.technique); });
  report.frame_ms = times.median_ms([](const auto& passes) { return total_ms(passes, ""); });
  return files.finish(report.outputs);
}

}  // namespace lueur::cli
