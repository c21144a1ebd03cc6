// SPDX-License-Identifier: MIT
#include "lueur/cube_map.h"

#include <algorithm>
#include <array>
#include <glm/gtc/type_ptr.hpp>
#include <map>

#include "cube_maps/cube_capture.h"
#include "cube_maps/equations.h"
#include "frame/recorder.h"
#include "frame/screen_of_view.h"
#include "lights/square_views.h"
#include "techniques/cube_map/maps.h"
#include "techniques/cube_map/params.h"
#include "techniques/cube_map/pixel_box.h"
#include "techniques/cube_map/shaders.h"
#include "techniques/lobe_data.h"

namespace lueur {
namespace {

using Settings = CubeMapSettings;
using cube_map::FaceIndex;
using cube_map::Map;
using cube_map::Maps;
using cube_map::PixelBox;
using cube_map::pixels_of_box;

constexpr std::string_view kSideNames[] = {"2", "4", "8", "16", "32", "64", "128", "256"};
constexpr std::string_view kPictureNames[] = {"64", "128", "256", "512"};
constexpr std::string_view kMethodNames[] = {"localized", "central"};

// The software rasterizer ends a thread's loops after 65 535 rounds.
constexpr uint32_t kMostTexelsAPass = 32768;

constexpr std::array kSettings = {
    choice<&Settings::side>("side", kSideNames, "Texels along a side of a map's faces."),
    choice<&Settings::picture>("picture", kPictureNames,
                               "Pixels along a side of the pictures that they are averaged from."),
    choice<&Settings::method>(
        "method", kMethodNames,
        "localized: texels as seen from each pixel; central: as seen from the map's centre."),
    toggle<&Settings::glossy>("glossy",
                              "Also give the light that glossy lobes reflect; needs reflectance."),
    setting<&Settings::blinn_exponent>(
        "blinn_exponent", 0, 1000, "",
        "Shininess of the paper's lobe, which then all surfaces have; 0: their own lobes."),
    setting<&Settings::most_maps>("most_maps", 1, 64, "maps",
                                  "Of objects. With more of those, more of them share a map."),
    setting<&Settings::share>(
        "share", 0, 16, "radii",
        "How large the ball around objects with one map may be, in those around the largest; 0: "
        "none share."),
    setting<&Settings::probes>("probes", 0, 3, "probes",
                               "Along the longest side of what is drawn, for what stands still."),
    setting<&Settings::faces_a_frame>("faces_a_frame", 1, 600, "faces",
                                      "Captured in a frame at most, but for those never captured."),
    setting<&Settings::move_threshold>("move_threshold", 0, 1, "radii",
                                       "How far an object moves before maps are captured again."),
};

uint32_t side_of(Settings::Side side) {
  return 2u << static_cast<uint32_t>(side);
}

uint32_t pixels_of(Settings::Picture picture) {
  return 64u << static_cast<uint32_t>(picture);
}

// Outside of all that is drawn, from wherever in it.
float far_of(const Box& bounds) {
  const glm::vec3 low = glm::make_vec3(bounds.min.data()), high = glm::make_vec3(bounds.max.data());
  return std::clamp(2.0f * glm::length(high - low), 1.0f, 1e6f);
}

// The passes of one frame.
class CubeMapFrame {
 public:
  CubeMapFrame(Frame& frame, const Settings& settings, const Inputs& inputs, Maps& maps)
      : public_frame_(frame),
        frame_(frame.recorder()),
        settings_(settings),
        inputs_(inputs),
        maps_(maps),
        extent_(inputs.g_buffer.depth.extent),
        camera_from_world_(glm::make_mat4(inputs.view.view_from_world.data())),
        camera_{screen_of_view(inputs.view, extent_), glm::mat3(camera_from_world_),
                as_ivec2(extent_)},
        side_(side_of(settings.side)),
        texels_a_map_(6 * side_ * side_),
        has_objects_(inputs.g_buffer.object.valid() && !inputs.host->objects().empty()),
        object_(has_objects_ ? inputs.g_buffer.object : inputs.g_buffer.normal) {}

  // Which maps there are, and what they show of the world as it is.
  void capture();
  // E / pi, or what the glossy lobes reflect.
  Image gather(bool glossy);

 private:
  void place(uint32_t map);
  void gather_from(uint32_t map, Image sum, bool glossy);
  MapShare share_of(uint32_t map) const;
  uint32_t localized() const { return settings_.method == Settings::Method::localized ? 1 : 0; }

  Frame& public_frame_;
  Recorder& frame_;
  const Settings& settings_;
  const Inputs& inputs_;
  Maps& maps_;
  Extent extent_;
  glm::mat4 camera_from_world_;
  CameraParams camera_;
  uint32_t side_, texels_a_map_;
  bool has_objects_;
  Image object_;
  Image atlas_{};  // faces side by side, maps one below the other
  BufferRef faces_{}, map_of_object_{}, lobes_{};
  BufferRef texels_{};  // of one map
};

void CubeMapFrame::capture() {
  Host& host = *inputs_.host;
  const std::span<const MovingObject> objects =
      has_objects_ ? host.objects() : std::span<const MovingObject>{};
  maps_.update(objects, host.lights(), host.bounds(),
               {settings_.most_maps, settings_.share, settings_.probes, settings_.move_threshold});
  if (maps_.maps().empty()) return;

  // What is kept from frame to frame.
  const auto rows = static_cast<uint32_t>(maps_.maps().size());
  const HistoryImage atlas =
      frame_.history("cube_map.atlas", {6 * side_, rows * side_}, kCubeTexelFormat);
  if (frame_.failed()) return;
  if (atlas.valid && !inputs_.cut) {
    frame_.copy(atlas.previous, atlas.current);
  } else {
    maps_.forget();
  }
  atlas_ = atlas.current;

  for (const FaceIndex& i : maps_.take_due(static_cast<size_t>(settings_.faces_a_frame))) {
    const Map& map = maps_.maps()[i.map];
    const View view = cube_views(map.faces[i.face].origin)[i.face];
    capture_face(public_frame_, host, view,
                 {.picture_px = pixels_of(settings_.picture),
                  .side = side_,
                  .without = map.objects,
                  .far_m = far_of(host.bounds())},
                 atlas_, glm::ivec2(i.face, i.map) * static_cast<int>(side_));
  }
}

void CubeMapFrame::place(uint32_t map) {
  if (!faces_.valid()) {
    std::vector<glm::mat4> camera_from_face;
    for (const Map& m : maps_.maps())
      for (size_t f = 0; f < 6; ++f)
        camera_from_face.push_back(
            camera_from_world_ *
            glm::inverse(glm::make_mat4(cube_views(m.faces[f].origin)[f].view_from_world.data())));
    faces_ = frame_.upload(camera_from_face);
    texels_ = frame_.buffer("texels", uint64_t{texels_a_map_} * sizeof(TexelLight));
    std::vector<uint32_t> map_of_object = maps_.map_of_object();
    if (map_of_object.empty()) map_of_object.push_back(0);
    map_of_object_ = frame_.upload(map_of_object);
    lobes_ = frame_.upload(lobe_data(inputs_.lobes));
  }
  frame_.dispatch(
      "cube_map.place",
      {.shader = shaders::techniques_cube_map_place_comp,
       .constants = {{"localized", localized()}},
       .params = PlaceParams{screen_of_view(cube_views({}).front(), {side_, side_}),
                             static_cast<int>(side_), static_cast<int>(map), texels_a_map_},
       .read = {{"atlas", atlas_}, {"faces", faces_}},
       .write = {{"texels", texels_}},
       .over = {texels_a_map_, 1}});
}

MapShare CubeMapFrame::share_of(uint32_t index) const {
  const Map& map = maps_.maps()[index];
  MapShare share{};
  share.map = index;
  share.is_probe = map.is_probe() ? 1 : 0;
  share.centre = glm::vec3(camera_from_world_ * glm::vec4(map.centre, 1.0f));
  const glm::vec3 spacing = maps_.probe_spacing();
  for (const Map& other : maps_.maps()) {
    if (!other.is_probe()) continue;
    for (int axis = 0; axis < 3; ++axis) {
      if (spacing[axis] == 0.0f) continue;
      if (other.centre[axis] > map.centre[axis] + 0.5f * spacing[axis])
        share.falls_up[axis] = 1.0f / spacing[axis];
      if (other.centre[axis] < map.centre[axis] - 0.5f * spacing[axis])
        share.falls_down[axis] = 1.0f / spacing[axis];
    }
  }
  return share;
}

void CubeMapFrame::gather_from(uint32_t index, Image sum, bool glossy) {
  const Map& map = maps_.maps()[index];
  const PixelBox pixels = map.is_probe() ? PixelBox{{0, 0}, as_ivec2(extent_)}
                                         : pixels_of_box(map.box, inputs_.view, extent_);
  if (pixels.is_empty()) return;
  place(index);
  const uint32_t pixels_per_thread = frame_.runs_on_cpu() ? 8 : 2;
  const glm::ivec2 size = pixels.end - pixels.first;
  for (uint32_t first = 0; first < texels_a_map_; first += kMostTexelsAPass) {
    const GatherParams params{camera_,
                              share_of(index),
                              pixels.first,
                              pixels.end,
                              first,
                              std::min(first + kMostTexelsAPass, texels_a_map_),
                              settings_.blinn_exponent};
    Dispatch dispatch{.shader = glossy ? shaders::techniques_cube_map_gather_glossy_comp
                                       : shaders::techniques_cube_map_gather_comp,
                      .constants = {{"pixels_per_thread", pixels_per_thread},
                                    {"localized", localized()},
                                    {"has_objects", has_objects_ ? 1u : 0u}},
                      .params = params,
                      .read = {{"depth", inputs_.g_buffer.depth},
                               {"normal", inputs_.g_buffer.normal},
                               {"object", object_},
                               {"map_of_object", map_of_object_},
                               {"texels", texels_}},
                      .write = {{"sum", sum}},
                      .over = {static_cast<uint32_t>(size.x),
                               divide_up(static_cast<uint32_t>(size.y), pixels_per_thread)}};
    if (glossy) {
      dispatch.read.push_back({"reflectance", inputs_.g_buffer.reflectance});
      dispatch.read.push_back({"lobes", lobes_});
    }
    frame_.dispatch(glossy ? "cube_map.gather_glossy" : "cube_map.gather", dispatch);
  }
}

Image CubeMapFrame::gather(bool glossy) {
  const Image sum = frame_.image("sum", extent_, Format::rgba32f);
  frame_.dispatch("cube_map.begin", {.shader = shaders::techniques_cube_map_begin_comp,
                                     .params = BeginParams{as_ivec2(extent_)},
                                     .write = {{"sum", sum}},
                                     .over = extent_});
  for (uint32_t map = 0; map < maps_.maps().size(); ++map) gather_from(map, sum, glossy);
  const Image light = frame_.image(glossy ? "specular" : "diffuse", extent_, Format::rgba16f);
  frame_.dispatch(glossy ? "cube_map.finish_glossy" : "cube_map.finish",
                  {.shader = shaders::techniques_cube_map_finish_comp,
                   .constants = {{"has_objects", has_objects_ ? 1u : 0u}},
                   .params = FinishParams{as_ivec2(extent_)},
                   .read = {{"sum", sum}, {"object", object_}},
                   .write = {{"light", light}},
                   .over = extent_});
  frame_.release(sum);
  return light;
}

}  // namespace

// What a technique knows of the frame before, by RecorderOptions::history_of.
struct CubeMap::Memory {
  std::map<std::string, Maps> maps;
};

CubeMap::CubeMap(CubeMapSettings settings)
    : settings_(settings), memory_(std::make_unique<Memory>()) {}
CubeMap::~CubeMap() = default;

std::span<const SettingInfo> CubeMap::settings_table() {
  return kSettings;
}

Outputs CubeMap::render(Frame& public_frame, const Inputs& inputs) {
  Recorder& frame = public_frame.recorder();
  const auto fail = [&](const char* message) { frame.fail({ErrorKind::usage, message}); };
  if (auto valid = check_ranges(kSettings, &settings_); !valid.ok()) frame.fail(valid.error());
  if (side_of(settings_.side) > pixels_of(settings_.picture))
    fail("cube_map: `side` is above `picture`, from whose pixels its texels are averaged");
  if (!inputs.host)
    fail("cube_map needs an engine that renders the faces of its maps (Inputs::host)");
  if (settings_.glossy && !inputs.g_buffer.reflectance.valid())
    fail("cube_map with glossy needs GBuffer::reflectance");
  if (frame.failed()) return {};

  CubeMapFrame steps(public_frame, settings_, inputs, memory_->maps[frame.options.history_of]);
  steps.capture();
  if (frame.failed()) return {};
  Outputs outputs{.diffuse = steps.gather(false)};
  if (settings_.glossy) outputs.specular = steps.gather(true);
  if (frame.failed()) return {};
  return outputs;
}

}  // namespace lueur
