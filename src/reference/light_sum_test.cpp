// SPDX-License-Identifier: MIT
// `lights` and `lights-unoccluded`: sums over patches that the lights shine on.
#include "reference/light_sum.h"

#include "reference/reference_fixture.h"
#include "scene/builtin/scene_builder.h"
#include "scene/builtin/shapes.h"

namespace lueur::reference {
namespace {

constexpr uint32_t kMany = 20'000;

double mean(const ImageF& image) {
  double sum = 0;
  for (const float value : image.samples) sum += static_cast<double>(value);
  return sum / static_cast<double>(image.samples.size());
}

ImageF indirect(const Scene& scene, Mode mode, uint32_t spp) {
  return layer(rendered(scene, kShot, {.mode = mode, .spp = spp}), "indirect");
}

// A room in which a light of each kind shines. All points of it see each other.
Scene bare_room() {
  Scene scene = inside_box();
  scene.materials[0].base_color = glm::vec4(0.7f, 0.5f, 0.3f, 1);
  add_light(scene, LightKind::point, 5.0f, {0.3f, 0.2f, -0.4f});
  add_light(scene, LightKind::spot, 20.0f, {0, 0.9f, 0}, {0.2f, -1, 0.1f}).outer_cone_rad = 0.6f;
  return scene;
}

Scene room_with_a_ball() {
  Scene scene = bare_room();
  builtin::MeshBuilder builder;
  builtin::add_sphere(builder, {-0.3f, -0.5f, -0.2f}, 0.3f, 24);
  builtin::add_mesh(scene, builder.finish("ball"));
  return scene;
}

// Many lights come to what paths find: one bounce of all light. Where there is an obstacle, only by
// shadow rays.
TEST(LightSum, ManyLightsAreTheTruth) {
  for (const bool has_ball : {false, true}) {
    const Scene scene = has_ball ? room_with_a_ball() : bare_room();
    const double truth = mean(indirect(scene, Mode::path, 4096));
    const double blocked = mean(indirect(scene, Mode::lights, kMany));
    const double open = mean(indirect(scene, Mode::lights_unoccluded, kMany));
    EXPECT_NEAR(blocked / truth, 1, 0.01);
    if (has_ball)
      EXPECT_GT(open / blocked, 1.02);
    else
      EXPECT_NEAR(open / blocked, 1, 1e-4);
  }
}

// The more lights, the closer; less than their number says, as next to a patch it is alone.
TEST(LightSum, ErrorFallsWithTheLights) {
  const Scene scene = bare_room();
  const ImageF truth = indirect(scene, Mode::lights, kMany);
  const auto error = [&](uint32_t count) {
    const ImageF found = indirect(scene, Mode::lights, count);
    double sum = 0;
    for (size_t i = 0; i < truth.samples.size(); ++i)
      sum += std::pow(static_cast<double>(found.samples[i] - truth.samples[i]), 2);
    return std::sqrt(sum / static_cast<double>(truth.samples.size())) / mean(truth);
  };
  const double few = error(100), more = error(1000);
  EXPECT_LT(few, 0.16);
  EXPECT_LT(more, 0.45 * few);
}

TEST(LightSum, WithoutLightsThereIsNone) {
  for (const Mode mode : {Mode::lights, Mode::lights_unoccluded})
    EXPECT_EQ(mean(indirect(inside_box(), mode, 100)), 0.0);
}

// How many lights there are says where they are: a finished picture is not of another number.
TEST(LightSum, ADifferentNumberIsADifferentPicture) {
  const Scene scene = bare_room();
  EXPECT_NE(indirect(scene, Mode::lights, 48).samples, indirect(scene, Mode::lights, 64).samples);
}

}  // namespace
}  // namespace lueur::reference
