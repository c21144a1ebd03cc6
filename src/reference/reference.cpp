// SPDX-License-Identifier: MIT
#include "reference/reference.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

#include "base/check.h"
#include "base/try.h"
#include "reference/accumulator.h"
#include "reference/content.h"
#include "reference/light_paths.h"
#include "reference/light_sum.h"
#include "reference/screen_sum.h"

namespace lueur::reference {
namespace {

constexpr uint32_t kTilePx = 16;
// Fewer say too little about their own spread to stop by it.
constexpr uint32_t kLeastPassesForError = 4;

constexpr std::array<ModeName, 6> kModeNames{{
    {"path", Mode::path, "path tracing of the scene: the truth"},
    {"screen", Mode::screen, "the same off what the camera sees alone: the best from one view"},
    {"screen-unoccluded", Mode::screen_unoccluded,
     "the sum over all pixels, through everything: what a gather on the screen estimates"},
    {"lights", Mode::lights, "the sum over what rays of the lights shine on, by shadow rays"},
    {"lights-unoccluded", Mode::lights_unoccluded,
     "the same through everything: what indirect lights estimate"},
    {"ambient", Mode::ambient, "ambient occlusion within a distance"},
}};

// Whether light is a finite sum, which no random numbers estimate.
bool is_sum(Mode mode) {
  return mode == Mode::screen_unoccluded || mode == Mode::lights || mode == Mode::lights_unoccluded;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::optional<EnvironmentLight> sky_of(const Scene& scene) {
  if (!scene.environment) return std::nullopt;
  EnvironmentLight sky(*scene.environment);
  return sky.empty() ? std::nullopt : std::optional(std::move(sky));
}

// One rendering from its start to its layers.
class Job {
 public:
  Job(const World& world, const Shot& shot, const Settings& settings, const Control& control)
      : world_(world),
        shot_(shot),
        settings_(settings),
        control_(control),
        camera_(world.scene().cameras[static_cast<size_t>(shot.camera)],
                world.world_from_node()[static_cast<size_t>(
                    world.scene().cameras[static_cast<size_t>(shot.camera)].node)],
                shot.width, shot.height),
        emitters_(world),
        sky_(sky_of(world.scene())),
        paths_(world_, emitters_, sky_ ? &*sky_ : nullptr, camera_, settings_),
        sums_(shot.width, shot.height),
        g_buffer_(shot.width, shot.height) {}

  Result<Rendering> run(const std::string& key, std::span<const uint8_t> resume_from);

 private:
  bool for_each_pixel(const std::function<void(uint32_t x, uint32_t y, uint64_t& rays)>& pixel,
                      bool may_stop);
  void see();
  bool trace_pass();
  uint32_t passes_wanted() const;
  void report();
  std::vector<ImageLayer> layers() const;

  const World& world_;
  const Shot& shot_;
  const Settings& settings_;
  const Control& control_;
  const PinholeCamera camera_;
  const Emitters emitters_;
  const std::optional<EnvironmentLight> sky_;  // none: there is none, or it is black
  const LightPaths paths_;
  Accumulator sums_;
  GBufferLayers g_buffer_;
  std::optional<ImageF> background_;  // where there is an environment; black before surfaces
  std::unique_ptr<PassSum> sum_;      // of modes that are finite sums
  std::vector<std::optional<FirstHit>> hits_;  // for it
  std::vector<PathSample> means_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::atomic<uint64_t> rays_ = 0;
  uint32_t passes_at_start_ = 0;
  Progress progress_;
};

// Calls `pixel` for every pixel, a tile at a time, from all threads. False when stopped early.
bool Job::for_each_pixel(const std::function<void(uint32_t x, uint32_t y, uint64_t& rays)>& pixel,
                         bool may_stop) {
  const uint32_t columns = (shot_.width + kTilePx - 1) / kTilePx;
  const uint32_t rows = (shot_.height + kTilePx - 1) / kTilePx;
  std::atomic<uint32_t> next = 0;
  const auto work = [&] {
    uint64_t rays = 0;
    for (uint32_t tile = next++; tile < columns * rows; tile = next++) {
      if (may_stop && control_.stop.stop_requested()) break;
      const uint32_t x0 = tile % columns * kTilePx, y0 = tile / columns * kTilePx;
      for (uint32_t y = y0; y < std::min(y0 + kTilePx, shot_.height); ++y)
        for (uint32_t x = x0; x < std::min(x0 + kTilePx, shot_.width); ++x) pixel(x, y, rays);
    }
    rays_ += rays;
  };
  const uint32_t threads =
      control_.threads > 0 ? control_.threads : std::max(std::thread::hardware_concurrency(), 1u);
  {
    std::vector<std::jthread> others;
    for (uint32_t i = 1; i < threads; ++i) others.emplace_back(work);
    work();
  }
  return !may_stop || !control_.stop.stop_requested();
}

// Everything that needs no random numbers.
void Job::see() {
  const bool keep = is_sum(settings_.mode);
  if (keep) hits_.resize(means_.size());
  const Scene& scene = world_.scene();
  std::optional<Backdrop> backdrop;
  if (scene.environment) {
    backdrop.emplace(*scene.environment, scene.cameras[static_cast<size_t>(shot_.camera)],
                     shot_.height);
    background_.emplace(shot_.width, shot_.height, 3);
  }
  for_each_pixel(
      [&](uint32_t x, uint32_t y, uint64_t& rays) {
        ++rays;
        const auto hit = first_hit(world_, camera_, x, y);
        if (!hit && backdrop) {
          const glm::vec2 centre(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
          store(*background_, x, y, backdrop->at(camera_.ray_through(centre).direction));
        }
        if (!hit) return;
        g_buffer_.set(world_, *hit, x, y, rays);
        if (keep) hits_[size_t{y} * shot_.width + x] = hit;
      },
      false);
  if (settings_.mode == Mode::screen_unoccluded)
    sum_ = std::make_unique<ScreenSum>(hits_, g_buffer_.source, camera_, settings_);
  else if (keep)
    sum_ = std::make_unique<LightSum>(world_, shot_, settings_);
}

uint32_t Job::passes_wanted() const {
  const uint32_t per_pass = sum_ ? sum_->items_per_pass() : kSamplesPerPass;
  const uint32_t wanted = (settings_.spp + per_pass - 1) / per_pass;
  if (!sum_) return std::max(wanted, 1u);
  return wanted == 0 ? sum_->passes() : std::min(wanted, sum_->passes());
}

// Adds one pass to the sums, unless it is stopped.
bool Job::trace_pass() {
  const uint32_t pass = sums_.passes();
  if (sum_) sum_->begin_pass(pass);
  const bool whole = for_each_pixel(
      [&](uint32_t x, uint32_t y, uint64_t& rays) {
        const size_t i = size_t{y} * shot_.width + x;
        means_[i] = {};
        if (sum_) {
          if (hits_[i]) means_[i].diffuse = sum_->at(*hits_[i], rays);
          return;
        }
        ++rays;
        const auto hit = first_hit(world_, camera_, x, y);
        if (!hit) return;
        const uint32_t seed = combined(combined(settings_.seed, x), y);
        const PathVertex first = paths_.begin(*hit);
        for (uint32_t k = 0; k < kSamplesPerPass; ++k) {
          Sampler sampler(seed, pass * kSamplesPerPass + k);
          const PathSample sample = paths_.sample(first, sampler, rays);
          means_[i].diffuse += sample.diffuse / static_cast<float>(kSamplesPerPass);
          means_[i].specular += sample.specular / static_cast<float>(kSamplesPerPass);
        }
      },
      true);
  if (whole) sums_.add_pass(means_);
  return whole;
}

void Job::report() {
  const uint32_t per_pass = sum_ ? sum_->items_per_pass() : kSamplesPerPass;
  progress_.spp_done = sums_.passes() * per_pass;
  progress_.spp_total = passes_wanted() * per_pass;
  progress_.relative_error = sums_.relative_error();
  progress_.seconds = seconds_since(start_);
  progress_.rays = rays_;
  const uint32_t done = sums_.passes() - passes_at_start_;
  double passes_left = passes_wanted() - std::min(sums_.passes(), passes_wanted());
  if (settings_.target_error > 0 && std::isfinite(progress_.relative_error)) {
    // Errors fall with the square root of the passes.
    const double ratio = progress_.relative_error / settings_.target_error;
    passes_left = std::min(passes_left, std::max((ratio * ratio - 1.0) * sums_.passes(), 0.0));
  }
  progress_.seconds_left = done > 0 ? progress_.seconds / done * passes_left : 0.0;
  if (control_.progress) control_.progress(progress_);
}

std::vector<ImageLayer> Job::layers() const {
  std::vector<ImageLayer> layers;
  if (settings_.mode == Mode::ambient) {
    const ImageF mean = sums_.diffuse(), spread = sums_.variance();
    ImageF occlusion(shot_.width, shot_.height, 1), variance(shot_.width, shot_.height, 1);
    for (size_t i = 0; i < occlusion.samples.size(); ++i) {
      occlusion.samples[i] = mean.samples[3 * i];
      variance.samples[i] = spread.samples[3 * i];
    }
    layers.push_back({"occlusion", std::move(occlusion)});
    layers.push_back({"variance", std::move(variance)});
  } else {
    const ImageF indirect = sums_.diffuse(), indirect_specular = sums_.specular();
    ImageF direct = g_buffer_.source, picture;
    for (size_t i = 0; i < direct.samples.size(); ++i)
      direct.samples[i] += g_buffer_.specular.samples[i];
    picture = direct;
    for (size_t i = 0; i < picture.samples.size(); ++i)
      picture.samples[i] += g_buffer_.albedo.samples[i] * indirect.samples[i] +
                            indirect_specular.samples[i] +
                            (background_ ? background_->samples[i] : 0.0f);
    layers.push_back({"", std::move(picture)});
    layers.push_back({"direct", std::move(direct)});
    layers.push_back({"indirect", indirect});
    if (settings_.mode == Mode::path) layers.push_back({"indirect_specular", indirect_specular});
    if (!is_sum(settings_.mode)) layers.push_back({"variance", sums_.variance()});
  }
  layers.push_back({"albedo", g_buffer_.albedo});
  layers.push_back({"normal", g_buffer_.normal});
  layers.push_back({"depth", g_buffer_.depth});
  layers.push_back({"specular", g_buffer_.specular});
  layers.push_back({"emission", g_buffer_.emission});
  layers.push_back({"source", g_buffer_.source});
  return layers;
}

Result<Rendering> Job::run(const std::string& key, std::span<const uint8_t> resume_from) {
  if (!resume_from.empty()) LUEUR_TRY_VOID(sums_.from_bytes(resume_from, key));
  passes_at_start_ = sums_.passes();
  means_.resize(size_t{shot_.width} * shot_.height);
  see();
  bool whole = true;
  auto checkpoint = std::chrono::steady_clock::now();
  for (report(); whole && sums_.passes() < passes_wanted(); report()) {
    if (settings_.target_error > 0 && sums_.passes() >= kLeastPassesForError &&
        progress_.relative_error <= settings_.target_error)
      break;
    whole = trace_pass();
    if (control_.checkpoint && seconds_since(checkpoint) >= control_.checkpoint_s) {
      control_.checkpoint(sums_.to_bytes(key));
      checkpoint = std::chrono::steady_clock::now();
    }
  }
  Rendering rendering{progress_, whole, layers(), {}};
  if (!whole) rendering.state = sums_.to_bytes(key);
  return rendering;
}

}  // namespace

std::span<const ModeName> mode_names() {
  return kModeNames;
}

std::string_view name_of(Mode mode) {
  return std::find_if(kModeNames.begin(), kModeNames.end(),
                      [&](const ModeName& row) { return row.mode == mode; })
      ->name;
}

const ImageF* find_layer(const Rendering& rendering, std::string_view name) {
  for (const ImageLayer& layer : rendering.layers)
    if (layer.name == name) return &layer.image;
  return nullptr;
}

Result<Rendering> render(const Scene& scene, const Shot& shot, const Settings& settings,
                         const Control& control, std::span<const uint8_t> resume_from) {
  LUEUR_CHECK(shot.camera >= 0 && static_cast<size_t>(shot.camera) < scene.cameras.size());
  LUEUR_CHECK(shot.width > 0 && shot.height > 0);
  LUEUR_CHECK(settings.bounces >= 1 && settings.bounces <= kMaxBounces);
  LUEUR_TRY(world, World::create(scene, shot.time_s));
  Job job(world, shot, settings, control);
  return job.run(content_key(scene, shot, settings), resume_from);
}

}  // namespace lueur::reference
