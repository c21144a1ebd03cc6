// SPDX-License-Identifier: MIT
// Which maps there are, where they are, and which of their faces are to be captured: all that is
// decided on the CPU, without a device.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "lueur/host.h"

namespace lueur::cube_map {

struct MapRules {
  int most_maps = 16;
  float share = 2.0f;            // in radii of the largest object of a map
  int probes = 1;                // along the longest side of what is drawn
  float move_threshold = 0.02f;  // in radii
  bool in_the_middle = false;    // of all that is drawn, instead of the objects
};

struct MapFace {
  // Where it was captured from: each face has its own centre, as they are not captured at once.
  glm::vec3 origin{0.0f};
  uint64_t world = 0;  // the state of lights and objects that it shows; 0: never captured
  uint64_t turn = 0;   // when it was captured, counted in captures
};

struct Map {
  std::vector<uint32_t> objects;  // in Host::objects(), at least one; none: a scene probe
  Box box{};                      // around the objects
  float spread_when_made = 1.0f;  // how large the ball around them may be, see update()
  glm::vec3 centre{0.0f};
  std::array<MapFace, 6> faces{};
  bool is_probe() const { return objects.empty(); }
};

struct FaceIndex {
  uint32_t map = 0, face = 0;
  bool operator==(const FaceIndex&) const = default;
};

class Maps {
 public:
  // Follows the frame's objects and lights. Objects share a map while the ball around them all is
  // not larger than `share` times that around the largest of them, once they share one 1.5 times
  // as large; with more maps than `most_maps`, as much more as it takes. Where the arrangement
  // changes, all faces of all maps are new.
  void update(std::span<const MovingObject> objects, std::span<const PunctualLight> lights,
              const Box& bounds, const MapRules& rules);
  // What the faces hold is lost.
  void forget();
  // The faces that show another state than the present one, those that are longest behind first: at
  // most `most`, but all that were never captured. They count as captured from their maps' centres.
  std::vector<FaceIndex> take_due(size_t most);

  // Those of objects, then probes, x fastest.
  const std::vector<Map>& maps() const { return maps_; }
  // How far apart probes are, 0 along axes that have one.
  glm::vec3 probe_spacing() const { return probe_spacing_; }
  // By object: the index of its map.
  const std::vector<uint32_t>& map_of_object() const { return map_of_object_; }

 private:
  using Groups = std::vector<std::vector<uint32_t>>;
  Groups grouped(std::span<const MovingObject> objects, const MapRules& rules) const;
  bool still_fits(std::span<const MovingObject> objects, const MapRules& rules) const;
  void arrange(std::span<const MovingObject> objects, const Box& bounds, const MapRules& rules);
  void arrange_probes(const Box& bounds, int probes);
  bool has_changed(std::span<const MovingObject> objects, std::span<const PunctualLight> lights,
                   float move_threshold) const;

  std::vector<Map> maps_;
  std::vector<uint32_t> map_of_object_;
  glm::vec3 probe_spacing_{0.0f};
  MapRules rules_{};
  // The present state, and what it was when it was counted up.
  uint64_t world_ = 0;
  std::vector<MovingObject> objects_;
  std::vector<PunctualLight> lights_;
  uint64_t turns_ = 0;
};

}  // namespace lueur::cube_map
