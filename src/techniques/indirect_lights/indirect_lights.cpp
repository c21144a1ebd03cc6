// SPDX-License-Identifier: MIT
#include "lueur/indirect_lights.h"

#include <array>
#include <glm/gtc/type_ptr.hpp>

#include "frame/device_list.h"
#include "frame/screen_of_view.h"
#include "lights/light_rays.h"
#include "lights/light_views.h"
#include "techniques/indirect_lights/params.h"
#include "techniques/indirect_lights/shaders.h"

namespace lueur {
namespace {

using Settings = IndirectLightsSettings;

constexpr std::string_view kLowResolutionNames[] = {"none", "half", "quarter"};
constexpr std::string_view kPlacingNames[] = {"halton", "random"};
constexpr uint32_t kThreads = 64;  // of refine.comp's workgroups

constexpr std::array kSettings = {
    setting<&Settings::lights>("lights", 1, 2048, "lights",
                               "Indirect lights, shared out among the scene's lights by flux."),
    setting<&Settings::negative_lights>("negative_lights", 0, 2048, "lights",
                                        "Negative ones, which take away what is blocked."),
    choice<&Settings::low_resolution>(
        "low_resolution", kLowResolutionNames,
        "What all pixels are gathered at first: none: full resolution, and nothing else."),
    setting<&Settings::discontinuity>(
        "discontinuity", 0, 4, "",
        "How far a pixel's normal, or its place in shares of its distance, may be from those of "
        "the pixel at low resolution, or it is gathered for anew."),
    toggle<&Settings::bound>("bound", "Bound the inverse square by the lights' areas."),
    setting<&Settings::light_view_px>("light_view_px", 16, 4096, "px",
                                      "Side of the views of lights."),
    choice<&Settings::placing>(
        "placing", kPlacingNames,
        "halton: the same rays in each frame; random: others for each seed."),
};

glm::mat4 as_mat4(const std::array<float, 16>& m) {
  return glm::make_mat4(m.data());
}

// The passes of one frame.
class IndirectLightsFrame {
 public:
  IndirectLightsFrame(Frame& frame, const Settings& settings, const Inputs& inputs)
      : public_frame_(frame),
        frame_(frame.recorder()),
        settings_(settings),
        inputs_(inputs),
        extent_(inputs.g_buffer.depth.extent),
        camera_from_world_(as_mat4(inputs.view.view_from_world)),
        camera_{screen_of_view(inputs.view, extent_), glm::mat3(camera_from_world_),
                as_ivec2(extent_)},
        pixels_per_thread_(frame_.runs_on_cpu() ? 8 : 2),
        count_(static_cast<uint32_t>(settings.lights)),
        negative_count_(static_cast<uint32_t>(settings.negative_lights)),
        lights_(frame_.buffer("lights", (count_ + negative_count_) * sizeof(IndirectLight))) {}

  void place_lights();
  void place_negative_lights();
  Image gather_all();
  Image gather_where_needed(int factor);

 private:
  struct Gathered {
    Image diffuse, geometry;
  };
  uint32_t all_lights() const { return count_ + negative_count_; }
  void place(const View& view, int32_t light, std::vector<PlacedRay> rays);
  Gathered gather(const std::string& pass, Extent extent, int factor);
  std::vector<gpu::Specialization> constants() const {
    return {{"pixels_per_thread", pixels_per_thread_}, {"bound", settings_.bound ? 1u : 0u}};
  }

  Frame& public_frame_;
  Recorder& frame_;
  const Settings& settings_;
  const Inputs& inputs_;
  Extent extent_;
  glm::mat4 camera_from_world_;
  CameraParams camera_;
  uint32_t pixels_per_thread_;
  uint32_t count_, negative_count_;
  BufferRef lights_;  // the negative ones behind the others
};

// Those of them that arrive in one view. Each is in one view of its light, so that all slots are
// written.
void IndirectLightsFrame::place(const View& view, int32_t light, std::vector<PlacedRay> rays) {
  const auto side_px = static_cast<uint32_t>(settings_.light_view_px);
  const Extent extent{side_px, side_px};
  const GBuffer g = inputs_.host->render_view(public_frame_, view, extent, {.light = light});
  if (!g.depth.valid())
    return frame_.fail({ErrorKind::usage, "the engine gives no G-buffer of other views"});
  const glm::mat4 view_from_world = as_mat4(view.view_from_world);
  const auto count = static_cast<uint32_t>(rays.size());
  frame_.dispatch(
      "indirect_lights.place",
      {.shader = shaders::techniques_indirect_lights_place_comp,
       .params = PlaceParams{screen_of_view(view, extent),
                             camera_from_world_ * glm::inverse(view_from_world),
                             glm::mat3(camera_from_world_), glm::mat3(view_from_world), count},
       .read = {{"depth", g.depth},
                {"normal", g.normal},
                {"source", g.source},
                {"rays", frame_.upload(rays)}},
       .write = {{"lights", lights_}},
       .over = {count, 1}});
}

void IndirectLightsFrame::place_lights() {
  const std::span<const PunctualLight> lights = inputs_.host->lights();
  const Box bounds = inputs_.host->bounds();
  const std::vector<uint32_t> shares = shares_of_lights(lights, bounds, count_);
  const uint32_t seed = settings_.placing == Settings::Placing::random ? inputs_.seed + 1 : 0;
  uint32_t slot = 0;
  for (size_t i = 0; i < lights.size() && !frame_.failed(); ++i) {
    const std::vector<LightRay> rays = rays_of_light(lights[i], bounds, shares[i], seed);
    std::vector<bool> taken(rays.size());
    for (const View& view : views_of_light(lights[i], bounds)) {
      std::vector<PlacedRay> placed;
      const auto side_px = static_cast<uint32_t>(settings_.light_view_px);
      for (const SeenLightRay& ray : rays_in_view(rays, view, side_px, taken))
        placed.push_back({ray.at_px, ray.solid_angle_sr, slot++});
      if (!placed.empty()) place(view, static_cast<int32_t>(i), std::move(placed));
    }
  }
  count_ = slot;
}

void IndirectLightsFrame::place_negative_lights() {
  if (negative_count_ == 0 || count_ == 0) {
    negative_count_ = 0;
    return;
  }
  frame_.dispatch("indirect_lights.negative",
                  {.shader = shaders::techniques_indirect_lights_negative_comp,
                   .constants = {{"bound", settings_.bound ? 1u : 0u}},
                   .params = NegativeParams{camera_, count_, negative_count_},
                   .read = {{"depth", inputs_.g_buffer.depth}, {"normal", inputs_.g_buffer.normal}},
                   .write = {{"lights", lights_}},
                   .over = {negative_count_, 1}});
}

IndirectLightsFrame::Gathered IndirectLightsFrame::gather(const std::string& pass, Extent extent,
                                                          int factor) {
  const Gathered result{frame_.image("diffuse", extent, Format::rgba16f),
                        frame_.image("geometry", extent, Format::rgba32f)};
  frame_.dispatch(pass, {.shader = shaders::techniques_indirect_lights_gather_comp,
                         .constants = constants(),
                         .params = GatherParams{camera_, as_ivec2(extent), factor, all_lights()},
                         .read = {{"depth", inputs_.g_buffer.depth},
                                  {"normal", inputs_.g_buffer.normal},
                                  {"lights", lights_}},
                         .write = {{"diffuse", result.diffuse}, {"geometry", result.geometry}},
                         .over = {extent.width, divide_up(extent.height, pixels_per_thread_)}});
  return result;
}

Image IndirectLightsFrame::gather_all() {
  const Gathered all = gather("indirect_lights.gather", extent_, 1);
  frame_.release(all.geometry);
  return all.diffuse;
}

Image IndirectLightsFrame::gather_where_needed(int factor) {
  const auto side = static_cast<uint32_t>(factor);
  const Extent low_extent{divide_up(extent_.width, side), divide_up(extent_.height, side)};
  const Gathered low = gather("indirect_lights.gather_low", low_extent, factor);

  const uint32_t pixels = extent_.width * extent_.height;
  const BufferRef list =
      device_list(frame_, "indirect_lights.begin_list", "list", pixels, sizeof(uint32_t));
  const Image diffuse = frame_.image("diffuse", extent_, Format::rgba16f);
  frame_.dispatch(
      "indirect_lights.interpolate",
      {.shader = shaders::techniques_indirect_lights_interpolate_comp,
       .params = InterpolateParams{camera_, as_ivec2(low_extent), factor, settings_.discontinuity},
       .read = {{"depth", inputs_.g_buffer.depth},
                {"normal", inputs_.g_buffer.normal},
                {"low_diffuse", low.diffuse},
                {"low_geometry", low.geometry}},
       .write = {{"diffuse", diffuse}, {"list", list}},
       .over = {low_extent.width + 1, low_extent.height + 1}});
  frame_.release(low.diffuse);
  frame_.release(low.geometry);
  const BufferRef groups = groups_of_list(frame_, "indirect_lights.end_list", list, pixels,
                                          kThreads * pixels_per_thread_);
  frame_.dispatch("indirect_lights.refine",
                  {.shader = shaders::techniques_indirect_lights_refine_comp,
                   .constants = constants(),
                   .params = RefineParams{camera_, all_lights()},
                   .read = {{"depth", inputs_.g_buffer.depth},
                            {"normal", inputs_.g_buffer.normal},
                            {"lights", lights_},
                            {"list", list}},
                   .write = {{"diffuse", diffuse}},
                   .groups = groups});
  return diffuse;
}

}  // namespace

std::span<const SettingInfo> IndirectLights::settings_table() {
  return kSettings;
}

Outputs IndirectLights::render(Frame& public_frame, const Inputs& inputs) {
  Recorder& frame = public_frame.recorder();
  if (auto valid = check_ranges(kSettings, &settings_); !valid.ok()) frame.fail(valid.error());
  if (!inputs.host)
    frame.fail({ErrorKind::usage,
                "indirect_lights needs an engine that renders its lights' views (Inputs::host)"});
  if (frame.failed()) return {};

  IndirectLightsFrame steps(public_frame, settings_, inputs);
  steps.place_lights();
  steps.place_negative_lights();
  const Image diffuse =
      settings_.low_resolution == Settings::LowResolution::none
          ? steps.gather_all()
          : steps.gather_where_needed(1 << static_cast<int>(settings_.low_resolution));
  if (frame.failed()) return {};
  return {.diffuse = diffuse};
}

}  // namespace lueur
