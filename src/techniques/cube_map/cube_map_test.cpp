// SPDX-License-Identifier: MIT
// The diffuse light of each pixel, and which map it takes when.
#include "techniques/cube_map/cube_map_fixture.h"

namespace lueur {
namespace {

TEST_F(CubeMapTest, IsTheLocalizedSumOfEachPixelsMap) {
  BallHost host(room, {{{-1.3, -0.5, -0.5}, 0.7}, {{1.5, 0.4, -1.4}, 0.9}});
  for (const auto side : {Settings::Side::of_2, Settings::Side::of_4, Settings::Side::of_16}) {
    settings_.side = side;
    expect_diffuse(host);
  }
}

TEST_F(CubeMapTest, ClassicalMapsTakeAllPointsForTheCentre) {
  settings_.method = Settings::Method::classical;
  settings_.side = Settings::Side::of_16;
  BallHost host(room, {{{-1.3, -0.5, -0.5}, 0.7}, {{1.5, 0.4, -1.4}, 0.9}});
  expect_diffuse(host);
  // And from the other side, where panoramas are folded.
  eye_ = {0.3, 0.2, -2.9};
  turn_ = turned(kPi + 0.1, 0.05);
  expect_diffuse(host);
}

// Between probes what they give is interpolated along each axis.
TEST_F(CubeMapTest, ProbesAreInterpolated) {
  settings_.probes = 2;  // 2 x 1 x 2 of them in a room of 6 x 4 x 6 m
  BallHost host(room, {{{-0.3, -0.5, -0.5}, 0.5}});
  render(host);
  std::vector<std::vector<ExactTexel>> maps;  // x fastest
  for (const double z : {-1.5, 1.5})
    for (const double x : {-1.5, 1.5})
      maps.push_back(exact_map(host.without({}), {x, 0, z}, side()));
  const Light found = all("diffuse");
  for (size_t i = 0; i < found.size(); ++i) {
    const glm::dvec3 x = position(i), n = normal(i);
    if (g_.depth[i] == 0 || host.ball_at(x)) continue;
    const glm::dvec3 part = glm::clamp((x + 1.5) / 3.0, 0.0, 1.0);
    const auto cosine = [&](const glm::dvec3& l) { return std::max(glm::dot(n, l), 0.0); };
    glm::dvec3 want(0);
    for (size_t c = 0; c < 4; ++c)
      want += (c % 2 ? part.x : 1 - part.x) * (c / 2 ? part.z : 1 - part.z) *
              exact_sum(maps[c], x, true, cosine) / kPi;
    for (int k = 0; k < 3; ++k) ASSERT_NEAR(found[i][k], want[k], 1e-3 * want[k] + 2e-5) << i;
  }
}

TEST_F(CubeMapTest, AfterACutNothingIsKept) {
  BallHost host(room, {{{-0.6, 0, 0}, 0.8}});
  CubeMap technique(settings_);
  render(technique, host);
  EXPECT_EQ(host.views, 12);
  is_cut_ = true;
  render(technique, host);
  EXPECT_EQ(host.views, 24);
}

// Radiance 1 from everywhere gives 1 to all points and normals, as far as few texels can tell.
TEST_F(CubeMapTest, AFurnaceIsUniform) {
  settings_.probes = 0;
  BallHost host(furnace, {{{0.3, 0.2, 0}, 1.0}});
  const std::pair<Settings::Side, double> tolerances[] = {
      {Settings::Side::of_2, 0.2}, {Settings::Side::of_4, 0.07}, {Settings::Side::of_8, 0.02}};
  for (const auto& [side, tolerance] : tolerances) {
    settings_.side = side;
    render(host);
    const Light found = all("diffuse");
    double low = 2, high = 0;
    for (size_t i = 0; i < found.size(); ++i) {
      if (!host.ball_at(position(i))) continue;
      low = std::min(low, found[i].x);
      high = std::max(high, found[i].x);
    }
    EXPECT_GT(low, 1 - tolerance) << static_cast<int>(side);
    EXPECT_LT(high, 1 + tolerance) << static_cast<int>(side);
  }
}

// LCM 6: the paper's room has one map in its middle, wherever the object is.
TEST_F(CubeMapTest, AMapMayStandInTheMiddleOfTheScene) {
  settings_.centre = Settings::Centre::scene;
  settings_.probes = 0;
  BallHost host(room, {{{-1.3, -0.5, -0.5}, 0.7}});
  render(host);
  expect_of_map(host, exact_map(host.without(std::vector{0u}), {0, 0, 0}, side()));
}

// Objects that share a map are not lit by each other.
TEST_F(CubeMapTest, NeighboursShareAMap) {
  settings_.share = 4.0f;
  settings_.probes = 0;
  BallHost host(room, {{{-0.6, 0, 0}, 0.5}, {{0.6, 0, 0}, 0.5}});
  render(host);
  EXPECT_EQ(host.views, 6);
  expect_of_map(host, exact_map(host.without(std::vector{0u, 1u}), {0, 0, 0}, side()));
}

// What stands still is captured once; what moves, so many faces a frame, and after all of them the
// picture is that of a technique that has seen nothing else.
TEST_F(CubeMapTest, FacesAreCapturedOverFrames) {
  settings_.faces_a_frame = 4;
  settings_.probes = 1;
  BallHost host(room, {{{-0.6, 0, 0}, 0.8}});
  CubeMap technique(settings_);
  render(technique, host);
  EXPECT_EQ(host.views, 12);
  const Light before = all("diffuse");
  render(technique, host);
  EXPECT_EQ(host.views, 12);
  EXPECT_EQ(all("diffuse"), before);
  host.move(0, {0.5, 0.2, -0.3});
  for (const int views : {16, 20, 24, 24}) {
    render(technique, host);
    EXPECT_EQ(host.views, views);
  }
  const Light after = all("diffuse");
  render(host);
  EXPECT_EQ(all("diffuse"), after);
  EXPECT_NE(after, before);
}

TEST_F(CubeMapTest, ManyTexelsAreTakenInParts) {
  settings_.side = Settings::Side::of_64;
  settings_.picture = Settings::Picture::of_64;
  settings_.probes = 0;
  BallHost host(furnace, {{{0.3, 0.2, 0}, 1.0}});
  render(host);
  settings_.side = Settings::Side::of_128;
  settings_.picture = Settings::Picture::of_128;
  const Light fewer = all("diffuse");
  render(host);  // 98 304 texels
  const Light more = all("diffuse");
  for (size_t i = 0; i < more.size(); ++i) ASSERT_NEAR(more[i].x, fewer[i].x, 2e-3) << i;
}

TEST_F(CubeMapTest, WhatIsMissingIsSaid) {
  const CpuGBuffer g = cast_g_buffer(room, {8, 8}, 0.9, {0, 0.1, 5.5});
  BallHost host(room, {});
  const auto error_of = [&](const Settings& settings, Host* given) {
    const auto result = system().run([&](VkCommandBuffer commands) {
      Frame frame = context().record(commands);
      GBuffer images = g.upload(recorder());
      const std::vector<uint8_t> nothing(64);
      images.object = recorder().upload_image("object", g.extent, Format::r8, nothing.data());
      CubeMap(settings).render(frame, {.view = g.view, .g_buffer = images, .host = given});
      return frame.finish();
    });
    return result.ok() ? std::string() : result.error().message;
  };
  EXPECT_NE(error_of({}, nullptr).find("Inputs::host"), std::string::npos);
  EXPECT_NE(error_of({.glossy = true}, &host).find("reflectance"), std::string::npos);
  EXPECT_NE(error_of({.side = Settings::Side::of_128, .picture = Settings::Picture::of_64}, &host)
                .find("`picture`"),
            std::string::npos);
  BallHost many(room, std::vector<Ball>(64, {{0, 0, 0}, 0.1}));
  if (82 * 256 > recorder().device().properties.limits.maxImageDimension2D) {
    EXPECT_NE(
        error_of({.side = Settings::Side::of_256, .most_maps = 64, .share = 0.0f, .probes = 3},
                 &many)
            .find("smaller `side`"),
        std::string::npos);
  }
  EXPECT_EQ(error_of({}, &host), "");
}

}  // namespace
}  // namespace lueur
