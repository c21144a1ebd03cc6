// SPDX-License-Identifier: MIT
#include "techniques/cube_map/cube_map_frame.h"

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>

#include "cube_maps/cube_capture.h"
#include "frame/screen_of_view.h"
#include "lights/square_views.h"
#include "techniques/cube_map/pixel_box.h"
#include "techniques/cube_map/shaders.h"
#include "techniques/lobe_data.h"

namespace lueur::cube_map {
namespace {

// The software rasterizer ends a thread's loops after 65 535 rounds.
constexpr uint32_t kMostTexelsAPass = 32768;
// The panoramas of a map, side by side.
constexpr Extent kPanoramas{kPanoramaSide * (1 + kRoughnesses), kPanoramaSide};

glm::mat4 to_world(const Map& map, size_t face) {
  return world_from_face(cube_views(map.faces[face].origin)[face]);
}

}  // namespace

CubeMapFrame::CubeMapFrame(Frame& frame, const CubeMapSettings& settings, const Inputs& inputs,
                           Maps& maps)
    : public_frame_(frame),
      frame_(frame.recorder()),
      settings_(settings),
      inputs_(inputs),
      maps_(maps),
      extent_(inputs.g_buffer.depth.extent),
      camera_from_world_(glm::make_mat4(inputs.view.view_from_world.data())),
      camera_{screen_of_view(inputs.view, extent_), glm::mat3(camera_from_world_),
              as_ivec2(extent_)},
      atlas_{{}, side_of(settings.side), {}},
      has_objects_(inputs.g_buffer.object.valid() && !inputs.host->objects().empty()),
      object_(has_objects_ ? inputs.g_buffer.object : inputs.g_buffer.normal) {}

bool CubeMapFrame::keep(const char* name, Extent of_a_map, Format format, Image& image) {
  const auto count = static_cast<uint32_t>(maps_.maps().size());
  const uint32_t height = of_a_map.height * count;
  const uint32_t limit = frame_.device().properties.limits.maxImageDimension2D;
  if (height > limit)
    frame_.fail({ErrorKind::usage, "cube_map: " + std::to_string(count) + " maps need an image " +
                                       std::to_string(height) + " pixels high, the device allows " +
                                       std::to_string(limit) +
                                       "; use a smaller `side`, or fewer maps or probes"});
  const HistoryImage history = frame_.history(name, {of_a_map.width, height}, format);
  image = history.current;
  const bool lasts = !frame_.failed() && history.valid && !inputs_.cut;
  if (lasts) frame_.copy(history.previous, history.current);
  return lasts;
}

void CubeMapFrame::capture() {
  Host& host = *inputs_.host;
  const std::span<const MovingObject> objects =
      has_objects_ ? host.objects() : std::span<const MovingObject>{};
  maps_.update(objects, host.lights(), host.bounds(),
               {settings_.most_maps, settings_.share, settings_.probes, settings_.move_threshold,
                settings_.centre == CubeMapSettings::Centre::scene});
  if (maps_.maps().empty()) return;

  bool lasts =
      keep("cube_map.atlas", {6 * atlas_.side, atlas_.side}, kCubeTexelFormat, atlas_.texels);
  if (is_classical()) lasts &= keep("cube_map.panoramas", kPanoramas, Format::rgba16f, panoramas_);
  if (frame_.failed()) return;
  if (!lasts) maps_.forget();

  std::vector<bool> is_new(maps_.maps().size());
  for (const FaceIndex& i : maps_.take_due(static_cast<size_t>(settings_.faces_a_frame))) {
    const Map& map = maps_.maps()[i.map];
    const View view = cube_views(map.faces[i.face].origin)[i.face];
    capture_face(public_frame_, host, view,
                 {.picture_px = pixels_of(settings_.picture),
                  .side = atlas_.side,
                  .without = map.objects,
                  .far_m = far_of(host.bounds())},
                 atlas_.texels, glm::ivec2(i.face, i.map) * static_cast<int>(atlas_.side));
    is_new[i.map] = true;
  }
  upload();
  if (!is_classical()) return;
  for (uint32_t map = 0; map < is_new.size(); ++map)
    if (is_new[map]) convolve(map);
}

// What the passes read of all maps.
void CubeMapFrame::upload() {
  std::vector<glm::mat4> to_world_or_camera;
  for (const Map& map : maps_.maps())
    for (size_t face = 0; face < 6; ++face)
      to_world_or_camera.push_back(is_classical() ? to_world(map, face)
                                                  : camera_from_world_ * to_world(map, face));
  atlas_.from_faces = frame_.upload(to_world_or_camera);
  std::vector<uint32_t> map_of_object = maps_.map_of_object();
  if (map_of_object.empty()) map_of_object.push_back(0);
  map_of_object_ = frame_.upload(map_of_object);
  lobes_ = frame_.upload(lobe_data(inputs_.lobes));
  if (!is_classical())
    texels_ = frame_.buffer("texels", uint64_t{atlas_.texels_a_map()} * sizeof(TexelLight));
}

void CubeMapFrame::convolve(uint32_t map) {
  frame_.dispatch("cube_map.convolve",
                  {.shader = shaders::techniques_cube_map_convolve_comp,
                   .params = place_params(atlas_, map),
                   .read = {{"atlas", atlas_.texels}, {"faces", atlas_.from_faces}},
                   .write = {{"panoramas", panoramas_}},
                   .over = kPanoramas});
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
  GatherParams params{camera_, share_of(index),         pixels.first, pixels.end, 0,
                      0,       settings_.blinn_exponent};
  if (is_classical()) return dispatch_gather(params, sum, glossy);
  place_texels(frame_, "cube_map.place", atlas_, index, texels_);
  for (; params.first_texel < atlas_.texels_a_map(); params.first_texel = params.end_texel) {
    params.end_texel = std::min(params.first_texel + kMostTexelsAPass, atlas_.texels_a_map());
    dispatch_gather(params, sum, glossy);
  }
}

void CubeMapFrame::dispatch_gather(const GatherParams& params, Image sum, bool glossy) {
  const uint32_t pixels_per_thread = frame_.runs_on_cpu() ? 8 : 2;
  const glm::ivec2 size = params.end - params.first;
  Dispatch dispatch{.shader = is_classical() ? shaders::techniques_cube_map_look_up_comp
                              : glossy       ? shaders::techniques_cube_map_gather_glossy_comp
                                             : shaders::techniques_cube_map_gather_comp,
                    .constants = {{"pixels_per_thread", pixels_per_thread},
                                  {"has_objects", has_objects_ ? 1u : 0u}},
                    .params = params,
                    .read = {{"depth", inputs_.g_buffer.depth},
                             {"normal", inputs_.g_buffer.normal},
                             {"object", object_},
                             {"map_of_object", map_of_object_}},
                    .write = {{"sum", sum}},
                    .over = {static_cast<uint32_t>(size.x),
                             divide_up(static_cast<uint32_t>(size.y), pixels_per_thread)}};
  if (is_classical()) {
    dispatch.constants.push_back({"glossy", glossy ? 1u : 0u});
    dispatch.read.push_back({"panoramas", panoramas_});
  } else {
    dispatch.read.push_back({"texels", texels_});
  }
  if (is_classical() || glossy) {
    const Image reflectance = inputs_.g_buffer.reflectance;
    dispatch.read.push_back({"reflectance", glossy ? reflectance : inputs_.g_buffer.normal});
    dispatch.read.push_back({"lobes", lobes_});
  }
  frame_.dispatch(glossy ? "cube_map.gather_glossy" : "cube_map.gather", dispatch);
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

}  // namespace lueur::cube_map
