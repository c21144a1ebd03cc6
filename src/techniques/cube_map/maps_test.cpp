// SPDX-License-Identifier: MIT
#include "techniques/cube_map/maps.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "techniques/cube_map/pixel_box.h"

namespace lueur::cube_map {
namespace {

constexpr Box kRoom{{-6, 0, -3}, {6, 3, 3}};

MovingObject cube_at(float x, float half = 0.5f) {
  return {{{x - half, 0, -half}, {x + half, 2 * half, half}}};
}

size_t probes_of(const Maps& maps) {
  return size_t(std::count_if(maps.maps().begin(), maps.maps().end(),
                              [](const Map& m) { return m.is_probe(); }));
}

TEST(Maps, EachObjectHasAMapAtItsCentre) {
  Maps maps;
  const MovingObject objects[] = {cube_at(-4), cube_at(4)};
  maps.update(objects, {}, kRoom, {.probes = 0});
  ASSERT_EQ(maps.maps().size(), 2u);
  EXPECT_EQ(maps.maps()[0].centre, glm::vec3(-4, 0.5f, 0));
  EXPECT_EQ(maps.maps()[1].objects, std::vector<uint32_t>{1});
  EXPECT_EQ(maps.map_of_object(), std::vector<uint32_t>({0, 1}));
}

TEST(Maps, NeighboursShareOne) {
  Maps maps;
  const MovingObject objects[] = {cube_at(0), cube_at(1), cube_at(5)};
  maps.update(objects, {}, kRoom, {.share = 2.0f, .probes = 0});
  ASSERT_EQ(maps.maps().size(), 2u);
  EXPECT_EQ(maps.maps()[0].objects, std::vector<uint32_t>({0, 1}));
  EXPECT_EQ(maps.maps()[0].centre, glm::vec3(0.5f, 0.5f, 0));
  Maps alone;
  alone.update(objects, {}, kRoom, {.share = 0.0f, .probes = 0});
  EXPECT_EQ(alone.maps().size(), 3u);
  // As many as are allowed.
  Maps few;
  few.update(objects, {}, kRoom, {.most_maps = 1, .share = 0.0f, .probes = 0});
  EXPECT_EQ(few.maps().size(), 1u);
  EXPECT_EQ(few.maps()[0].objects.size(), 3u);
}

TEST(Maps, ProbesStandInTheMiddlesOfCells) {
  Maps maps;
  maps.update({}, {}, kRoom, {.probes = 2});
  ASSERT_EQ(probes_of(maps), 2u);  // 12 x 3 x 6 m: 2 x 1 x 1
  EXPECT_EQ(maps.maps()[0].centre, glm::vec3(-3, 1.5f, 0));
  EXPECT_EQ(maps.maps()[1].centre, glm::vec3(3, 1.5f, 0));
  EXPECT_EQ(maps.probe_spacing(), glm::vec3(6, 0, 0));
  maps.update({}, {}, kRoom, {.probes = 0});
  EXPECT_TRUE(maps.maps().empty());
}

TEST(Maps, FacesAreCapturedOnceAndThenWhenSomethingChanges) {
  Maps maps;
  const MapRules rules{.probes = 1, .move_threshold = 0.1f};
  MovingObject object = cube_at(0);
  PunctualLight light;
  const auto update = [&] { maps.update({&object, 1}, {&light, 1}, kRoom, rules); };
  update();
  EXPECT_EQ(maps.take_due(1).size(), 12u);  // what was never captured, whatever the most
  update();
  EXPECT_TRUE(maps.take_due(100).empty());
  object = cube_at(0.05f);  // 0.06 of its radius
  update();
  EXPECT_TRUE(maps.take_due(100).empty());
  object = cube_at(0.1f);  // 0.12 from where it was when the maps were captured
  update();
  EXPECT_EQ(maps.take_due(100).size(), 12u);
  EXPECT_NEAR(maps.maps()[0].faces[3].origin.x, 0.1f, 1e-6f);
  light.intensity = {1, 0, 0};
  update();
  EXPECT_EQ(maps.take_due(100).size(), 12u);
  maps.forget();
  EXPECT_EQ(maps.take_due(1).size(), 12u);
}

// With two faces a frame, each of the twelve has its turn in six frames, whatever moves meanwhile.
TEST(Maps, FacesTakeTurns) {
  Maps maps;
  MovingObject object = cube_at(0);
  maps.update({&object, 1}, {}, kRoom, {.probes = 1});
  maps.take_due(100);
  std::vector<FaceIndex> taken;
  for (int frame = 1; frame <= 12; ++frame) {
    object = cube_at(float(frame));
    maps.update({&object, 1}, {}, kRoom, {.probes = 1});
    const auto due = maps.take_due(2);
    ASSERT_EQ(due.size(), 2u);
    for (const FaceIndex& i : due) {
      EXPECT_EQ(maps.maps()[i.map].faces[i.face].origin, maps.maps()[i.map].centre);
      taken.push_back(i);
    }
  }
  for (size_t i = 0; i < 12; ++i) {
    EXPECT_EQ(std::count(taken.begin(), taken.begin() + 12, taken[i]), 1) << i;
    EXPECT_EQ(taken[i], taken[i + 12]) << i;
  }
}

// Two that move apart keep their map a while, then all are arranged anew, once.
TEST(Maps, ArrangementsLastAWhile) {
  Maps maps;
  MovingObject objects[] = {cube_at(0), cube_at(1)};
  int changes = 0;
  size_t before = 1;
  for (int i = 0; i <= 80; ++i) {
    objects[1] = cube_at(1 + 0.05f * float(i));
    maps.update(objects, {}, kRoom, {.probes = 0});
    changes += maps.maps().size() != before;
    before = maps.maps().size();
    if (i == 10) {
      EXPECT_EQ(before, 1u);
    }
  }
  EXPECT_EQ(changes, 1);
  EXPECT_EQ(before, 2u);
}

TEST(PixelBox, HoldsWhatIsSeenOfABox) {
  View view;
  for (size_t i = 0; i < 16; i += 5) view.view_from_world[i] = 1;
  view.clip_from_view = {1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 0, -1, 0, 0, 0.1f, 0};
  const Extent extent{100, 100};
  // At z = -2, x from 0 to 1 and y from 0 to 1: a quarter of the upper right.
  const PixelBox seen = pixels_of_box({{0, 0, -3}, {1, 1, -2}}, view, extent);
  EXPECT_EQ(seen.first, glm::ivec2(49, 24));
  EXPECT_EQ(seen.end, glm::ivec2(76, 51));
  EXPECT_TRUE(pixels_of_box({{8, 0, -3}, {9, 1, -2}}, view, extent).is_empty());
  EXPECT_EQ(pixels_of_box({{-1, -1, -3}, {1, 1, 3}}, view, extent).end, glm::ivec2(100, 100));
}

}  // namespace
}  // namespace lueur::cube_map
