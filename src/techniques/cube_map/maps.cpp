// SPDX-License-Identifier: MIT
#include "techniques/cube_map/maps.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lueur::cube_map {
namespace {

// How much larger than when it was made a group may grow before all are arranged anew: what moves
// together and apart would else jump from map to map.
constexpr float kTolerance = 1.5f;

glm::vec3 low_of(const Box& box) {
  return {box.min[0], box.min[1], box.min[2]};
}

glm::vec3 high_of(const Box& box) {
  return {box.max[0], box.max[1], box.max[2]};
}

glm::vec3 centre_of(const Box& box) {
  return 0.5f * (low_of(box) + high_of(box));
}

float radius_of(const Box& box) {
  return 0.5f * glm::length(high_of(box) - low_of(box));
}

Box around(const Box& a, const Box& b) {
  Box box = a;
  for (size_t i = 0; i < 3; ++i) {
    box.min[i] = std::min(a.min[i], b.min[i]);
    box.max[i] = std::max(a.max[i], b.max[i]);
  }
  return box;
}

Box around(std::span<const MovingObject> objects, const std::vector<uint32_t>& group) {
  Box box = objects[group.front()].bounds;
  for (const uint32_t i : group) box = around(box, objects[i].bounds);
  return box;
}

// The ball around all of a group, in balls around the largest of it.
float spread(std::span<const MovingObject> objects, const std::vector<uint32_t>& group) {
  float largest = 1e-6f;
  for (const uint32_t i : group) largest = std::max(largest, radius_of(objects[i].bounds));
  return radius_of(around(objects, group)) / largest;
}

bool has_moved(const Box& now, const Box& before, float threshold) {
  const float least = threshold * radius_of(before);
  return glm::length(low_of(now) - low_of(before)) > least ||
         glm::length(high_of(now) - high_of(before)) > least;
}

}  // namespace

Maps::Groups Maps::grouped(std::span<const MovingObject> objects, const MapRules& rules) const {
  float share = std::max(rules.share, 1.0f);
  while (true) {
    Groups groups;
    for (uint32_t i = 0; i < objects.size(); ++i) {
      bool found = false;
      for (std::vector<uint32_t>& group : groups) {
        group.push_back(i);
        found = rules.share > 0.0f && spread(objects, group) <= share;
        if (found) break;
        group.pop_back();
      }
      if (!found) groups.push_back({i});
    }
    if (groups.size() <= static_cast<size_t>(rules.most_maps)) return groups;
    // Without sharing there is no other way than to begin it.
    if (rules.share <= 0.0f) return grouped(objects, {.most_maps = rules.most_maps, .share = 1.0f});
    share *= kTolerance;
  }
}

bool Maps::still_fits(std::span<const MovingObject> objects, const MapRules& rules) const {
  if (objects.size() != map_of_object_.size() || rules.most_maps != rules_.most_maps ||
      rules.share != rules_.share || rules.probes != rules_.probes || maps_.empty())
    return false;
  return std::all_of(maps_.begin(), maps_.end(), [&](const Map& map) {
    return map.is_probe() || spread(objects, map.objects) <= kTolerance * map.spread_when_made;
  });
}

void Maps::arrange(std::span<const MovingObject> objects, const Box& bounds,
                   const MapRules& rules) {
  maps_.clear();
  map_of_object_.assign(objects.size(), 0);
  for (std::vector<uint32_t>& group : grouped(objects, rules)) {
    for (const uint32_t i : group) map_of_object_[i] = static_cast<uint32_t>(maps_.size());
    Map map;
    map.spread_when_made = std::max(spread(objects, group), rules.share);
    map.objects = std::move(group);
    maps_.push_back(std::move(map));
  }
  arrange_probes(bounds, rules.probes);
  rules_ = rules;
}

void Maps::arrange_probes(const Box& bounds, int probes) {
  probe_spacing_ = glm::vec3(0.0f);
  if (probes == 0) return;
  const glm::vec3 low = low_of(bounds), size = high_of(bounds) - low;
  const float longest = std::max({size.x, size.y, size.z, 1e-6f});
  glm::ivec3 count;
  for (int i = 0; i < 3; ++i)
    count[i] = std::max(static_cast<int>(std::lround(size[i] / longest * float(probes))), 1);
  const glm::vec3 cell = size / glm::vec3(count);
  for (int z = 0; z < count.z; ++z) {
    for (int y = 0; y < count.y; ++y) {
      for (int x = 0; x < count.x; ++x) {
        Map map;
        map.centre = low + (glm::vec3(x, y, z) + 0.5f) * cell;
        maps_.push_back(std::move(map));
      }
    }
  }
  for (int i = 0; i < 3; ++i)
    if (count[i] > 1) probe_spacing_[i] = cell[i];
}

bool Maps::has_changed(std::span<const MovingObject> objects, std::span<const PunctualLight> lights,
                       float move_threshold) const {
  if (objects.size() != objects_.size() || !std::ranges::equal(lights, lights_)) return true;
  for (size_t i = 0; i < objects.size(); ++i)
    if (has_moved(objects[i].bounds, objects_[i].bounds, move_threshold)) return true;
  return false;
}

void Maps::update(std::span<const MovingObject> objects, std::span<const PunctualLight> lights,
                  const Box& bounds, const MapRules& rules) {
  if (!still_fits(objects, rules)) arrange(objects, bounds, rules);
  for (Map& map : maps_) {
    if (map.is_probe()) continue;
    map.box = around(objects, map.objects);
    map.centre = centre_of(rules.in_the_middle ? bounds : map.box);
  }
  if (world_ == 0 || has_changed(objects, lights, rules.move_threshold)) {
    ++world_;
    objects_.assign(objects.begin(), objects.end());
    lights_.assign(lights.begin(), lights.end());
  }
}

void Maps::forget() {
  for (Map& map : maps_) map.faces = {};
}

std::vector<FaceIndex> Maps::take_due(size_t most) {
  std::vector<FaceIndex> due;
  for (uint32_t m = 0; m < maps_.size(); ++m)
    for (uint32_t f = 0; f < 6; ++f)
      if (maps_[m].faces[f].world != world_) due.push_back({m, f});
  const auto face = [&](const FaceIndex& i) -> MapFace& { return maps_[i.map].faces[i.face]; };
  std::stable_sort(due.begin(), due.end(), [&](const FaceIndex& a, const FaceIndex& b) {
    return face(a).turn < face(b).turn;
  });
  const auto never = static_cast<size_t>(std::count_if(
      due.begin(), due.end(), [&](const FaceIndex& i) { return face(i).world == 0; }));
  due.resize(std::min(due.size(), std::max(most, never)));
  for (const FaceIndex& i : due) face(i) = {maps_[i.map].centre, world_, ++turns_};
  return due;
}

}  // namespace lueur::cube_map
