// SPDX-License-Identifier: MIT
// What the technique gives, against LCM's sums in double precision over the same pictures.
#include "lueur/cube_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <type_traits>

#include "cube_maps/equations.h"
#include "lights/square_views.h"
#include "support/gpu_test.h"

namespace lueur {
namespace {

using Settings = CubeMapSettings;
using Light = std::vector<glm::dvec3>;  // a value a pixel

constexpr uint32_t kPicturePx = 64;
constexpr CosineLobe kLobe{.exponent = 6.0f};  // of all surfaces
const Box kRoomBounds{{-3, -2, -3}, {3, 2, 3}};
const double kFar = 2 * std::sqrt(36.0 + 16.0 + 36.0);

// The inside of a sphere of radius 4 and radiance 1.
std::optional<CpuHit> furnace(const glm::dvec3& o, const glm::dvec3& d) {
  const double a = glm::dot(d, d), b = glm::dot(o, d), c = glm::dot(o, o) - 16.0;
  const double t = (-b + std::sqrt(b * b - a * c)) / a;
  const glm::dvec3 p = o + t * d;
  return CpuHit{p, -p / 4.0, glm::dvec3(1)};
}

// A room of 6 x 4 x 6 m whose sides glow in different colours, open at the front.
std::optional<CpuHit> room(const glm::dvec3& o, const glm::dvec3& d) {
  std::optional<CpuHit> best;
  double nearest = 1e30;
  const auto plane = [&](const glm::dvec3& n, double at, const glm::dvec3& radiance) {
    const double facing = glm::dot(n, d);
    if (facing >= 0) return;
    const double t = (at - glm::dot(n, o)) / facing;
    if (t <= 1e-9 || t >= nearest) return;
    const glm::dvec3 p = o + t * d;
    if (glm::any(glm::greaterThan(glm::abs(p), glm::dvec3(3.001)))) return;
    nearest = t;
    best = CpuHit{p, n, radiance * (1.5 + std::sin(2 * p.x + p.y))};
  };
  plane({0, 1, 0}, -2, {0.7, 0.7, 0.6});
  plane({0, -1, 0}, -2, {0.5, 0.5, 0.5});
  plane({0, 0, 1}, -3, {0.6, 0.6, 0.7});
  plane({1, 0, 0}, -3, {0.7, 0.2, 0.1});
  plane({-1, 0, 0}, -3, {0.1, 0.6, 0.2});
  return best;
}

struct Ball {
  glm::dvec3 centre;
  double radius;
};

std::optional<double> meet(const Ball& ball, const glm::dvec3& o, const glm::dvec3& d) {
  const glm::dvec3 off = o - ball.centre;
  const double a = glm::dot(d, d), b = glm::dot(off, d);
  const double root = b * b - a * (glm::dot(off, off) - ball.radius * ball.radius);
  const double t = root < 0 ? -1 : (-b - std::sqrt(root)) / a;
  return t > 1e-9 ? std::optional(t) : std::nullopt;
}

// An engine with surroundings and balls that move in them, which glow white.
class BallHost final : public Host {
 public:
  BallHost(CpuScene around, std::vector<Ball> balls)
      : around_(std::move(around)), balls_(std::move(balls)) {
    place();
  }
  GBuffer render_view(Frame& frame, const View& view, Extent extent,
                      const ViewContent& content) override {
    ++views;
    return seen_through(without(content.without), view, extent).upload(frame.recorder());
  }
  std::span<const PunctualLight> lights() const override { return {}; }
  std::span<const MovingObject> objects() const override { return objects_; }
  Box bounds() const override { return kRoomBounds; }
  std::span<const TriangleBatch> triangles(Frame&) override { return {}; }

  CpuScene without(std::span<const uint32_t> left_out) const {
    return [this, out = std::vector(left_out.begin(), left_out.end())](const glm::dvec3& o,
                                                                       const glm::dvec3& d) {
      auto hit = around_(o, d);
      double nearest = hit ? glm::length(hit->position - o) / glm::length(d) : 1e30;
      for (uint32_t i = 0; i < balls_.size(); ++i) {
        const auto t = meet(balls_[i], o, d);
        if (!t || *t >= nearest || std::find(out.begin(), out.end(), i) != out.end()) continue;
        nearest = *t;
        const glm::dvec3 p = o + *t * d;
        hit = CpuHit{p, (p - balls_[i].centre) / balls_[i].radius, glm::dvec3(2)};
      }
      return hit;
    };
  }
  // The ball on which the point lies.
  std::optional<uint32_t> ball_at(const glm::dvec3& p) const {
    for (uint32_t i = 0; i < balls_.size(); ++i)
      if (std::abs(glm::length(p - balls_[i].centre) - balls_[i].radius) < 1e-4) return i;
    return std::nullopt;
  }
  void move(size_t ball, const glm::dvec3& by) {
    balls_[ball].centre += by;
    place();
  }
  const std::vector<Ball>& balls() const { return balls_; }

  int views = 0;

 private:
  void place() {
    objects_.clear();
    for (const Ball& b : balls_) {
      const glm::vec3 low = b.centre - b.radius, high = b.centre + b.radius;
      objects_.push_back({{{low.x, low.y, low.z}, {high.x, high.y, high.z}}});
    }
  }
  CpuScene around_;
  std::vector<Ball> balls_;
  std::vector<MovingObject> objects_;
};

// A texel as LCM 5 has it.
struct ExactTexel {
  glm::dvec3 centre, direction, radiance;
  double distance, solid_angle;
};

std::vector<ExactTexel> exact_map(const CpuScene& scene, const glm::dvec3& centre, uint32_t side) {
  std::vector<ExactTexel> texels;
  const uint32_t factor = kPicturePx / side;
  for (const View& view : cube_views(centre)) {
    const CpuGBuffer g = seen_through(scene, view, {kPicturePx, kPicturePx});
    const glm::dmat3 to_world(world_from_view(view));
    for (uint32_t y = 0; y < side; ++y) {
      for (uint32_t x = 0; x < side; ++x) {
        glm::dvec3 radiance(0);
        double distance = 0, count = 0;
        for (uint32_t i = 0; i < factor * factor; ++i) {
          const size_t pixel =
              size_t{y * factor + i / factor} * kPicturePx + x * factor + i % factor;
          const bool is_there = g.depth[pixel] > 0;
          radiance += is_there ? glm::dvec3(g.source[pixel]) : glm::dvec3(0);
          if (is_there) distance += glm::length(g.position_view[pixel]);
          count += is_there;
        }
        const glm::dvec3 ray((2 * x + 1.0) / side - 1, 1 - (2 * y + 1.0) / side, -1);
        const double l = glm::length(ray);
        texels.push_back({centre, glm::normalize(to_world * ray),
                          radiance / double(factor * factor), count > 0 ? distance / count : kFar,
                          4 / (side * side * l * l * l + 4 / kPi)});
      }
    }
  }
  return texels;
}

// LCM (3) with the reflectivity `a`, which gets the unit direction to the light and,
// if it wants it, the solid angle in which that is seen.
template <class Reflectivity>
glm::dvec3 exact_sum(const std::vector<ExactTexel>& texels, const glm::dvec3& x, bool localized,
                     const Reflectivity& a) {
  glm::dvec3 sum(0);
  for (const ExactTexel& t : texels) {
    const glm::dvec3 way = (localized ? t.centre - x : glm::dvec3(0)) + t.direction * t.distance;
    const double r2 = glm::dot(way, way), d2 = t.distance * t.distance;
    const double share = t.solid_angle / kPi;
    const double seen =
        localized ? d2 * t.solid_angle / (r2 * (1 - share) + d2 * share) : t.solid_angle;
    if constexpr (std::is_invocable_v<Reflectivity, glm::dvec3, double>)
      sum += t.radiance * (a(way / std::sqrt(r2), seen) * seen);
    else
      sum += t.radiance * (a(way / std::sqrt(r2)) * seen);
  }
  return sum;
}

class CubeMapTest : public GpuTest {
 protected:
  CubeMapTest() {
    settings_.picture = Settings::Picture::of_64;
    settings_.share = 0.0f;
  }
  void render(CubeMap& technique, BallHost& host) {
    g_ = cast_g_buffer(host.without({}), {64, 40}, 0.9, eye_, turn_);
    g_.reflectance.assign(g_.depth.size(), {0.5f, 0.25f, 1.0f, -1.0f});
    std::vector<uint8_t> object(g_.depth.size());
    for (size_t i = 0; i < object.size(); ++i)
      if (const auto ball = host.ball_at(position(i))) object[i] = static_cast<uint8_t>(*ball + 1);
    run([&](Frame& frame) {
      GBuffer g = g_.upload(recorder());
      g.object = recorder().upload_image("object", g_.extent, Format::r8, object.data());
      const Outputs out = technique.render(
          frame,
          {.view = g_.view, .g_buffer = g, .cut = is_cut_, .lobes = {&kLobe, 1}, .host = &host});
      recorder().read_back("diffuse", out.diffuse);
      if (out.specular.valid()) recorder().read_back("specular", out.specular);
    });
  }
  void render(BallHost& host) {
    CubeMap technique(settings_);
    render(technique, host);
  }
  glm::dvec4 at(const char* image, size_t i) {
    if (image != last_name_) last_ = pixels(last_name_ = image);
    const float* s = &last_.samples[4 * i];
    return {s[0], s[1], s[2], s[3]};
  }
  Light all(const char* image) {
    const Pixels p = pixels(image);
    Light light;
    for (size_t i = 0; i + 3 < p.samples.size(); i += 4)
      light.emplace_back(p.samples[i], p.samples[i + 1], p.samples[i + 2]);
    return light;
  }
  glm::dvec3 position(size_t i) const {
    return glm::dvec3(world_from_view(g_.view) * glm::dvec4(g_.position_view[i], 1));
  }
  glm::dvec3 normal(size_t i) const { return glm::dvec3(g_.normal[i]); }
  uint32_t side() const { return 2u << static_cast<uint32_t>(settings_.side); }

  // The balls' pixels of the last frame against the sum over one map.
  void expect_of_map(const BallHost& host, const std::vector<ExactTexel>& map) {
    const Light found = all("diffuse");
    for (size_t i = 0; i < found.size(); ++i) {
      if (g_.depth[i] == 0 || !host.ball_at(position(i))) continue;
      const glm::dvec3 n = normal(i);
      const auto cosine = [&](const glm::dvec3& l) { return std::max(glm::dot(n, l), 0.0); };
      const glm::dvec3 want = exact_sum(map, position(i), true, cosine) / kPi;
      for (int k = 0; k < 3; ++k) ASSERT_NEAR(found[i][k], want[k], 1e-3 * want[k] + 2e-5) << i;
    }
  }
  // Each pixel against the sum over its own map: of its ball, or the room's one probe.
  void expect_diffuse(BallHost& host) {
    render(host);
    const bool localized = settings_.method == Settings::Method::localized;
    std::vector<std::vector<ExactTexel>> maps;
    for (uint32_t i = 0; i < host.balls().size(); ++i)
      maps.push_back(exact_map(host.without(std::vector{i}), host.balls()[i].centre, side()));
    maps.push_back(exact_map(host.without({}), {0, 0, 0}, side()));
    const Light found = all("diffuse");
    size_t on_balls = 0;
    for (size_t i = 0; i < found.size(); ++i) {
      if (g_.depth[i] == 0) {
        ASSERT_EQ(found[i], glm::dvec3(0));
        continue;
      }
      const auto ball = host.ball_at(position(i));
      on_balls += ball.has_value();
      const glm::dvec3 n = normal(i);
      const glm::dvec3 want =
          exact_sum(maps[ball.value_or(static_cast<uint32_t>(maps.size() - 1))], position(i),
                    localized, [&](const glm::dvec3& l) { return std::max(glm::dot(n, l), 0.0); }) /
          kPi;
      // Half floats, or what 32 x 32 directions leave out.
      const double tolerance = localized ? 1e-3 : 2e-2;
      for (int c = 0; c < 3; ++c)
        ASSERT_NEAR(found[i][c], want[c], tolerance * want[c] + 2e-5) << i << ' ' << side();
      ASSERT_EQ(at("diffuse", i).w, ball ? 1.0 : 0.0);
    }
    EXPECT_GT(on_balls, 150u);
    last_name_ = nullptr;
  }

  // Turned, so that world and view are not taken for each other.
  static glm::dmat3 turned(double yaw, double pitch) {
    return glm::dmat3(glm::rotate(glm::rotate(glm::dmat4(1), yaw, {0, 1, 0}), pitch, {1, 0, 0}));
  }
  Settings settings_;
  CpuGBuffer g_;
  glm::dvec3 eye_{0.6, 0.5, 5.5};
  glm::dmat3 turn_ = turned(0.1, -0.08);
  bool is_cut_ = false;

 private:
  const char* last_name_ = nullptr;
  Pixels last_;
};

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

// LCM 5's lobe, with all that a point reflects; a map of 16 x 16 texels is enough to tell signs.
TEST_F(CubeMapTest, BlinnsLobeIsSummedTheSameWay) {
  settings_.glossy = true;
  settings_.blinn_exponent = 5.0f;
  settings_.side = Settings::Side::of_16;
  settings_.probes = 0;
  BallHost host(room, {{{-0.3, -0.5, -0.5}, 1.2}});
  render(host);
  const auto map = exact_map(host.without(std::vector{0u}), host.balls()[0].centre, side());
  const double c = 7 * 9 / (8 * kPi * (std::pow(2, -2.5) + 5));
  const Light found = all("specular");
  for (size_t i = 0; i < found.size(); ++i) {
    const glm::dvec3 x = position(i), n = normal(i);
    if (g_.depth[i] == 0 || !host.ball_at(x)) {
      ASSERT_EQ(found[i], glm::dvec3(0)) << i;
      continue;
    }
    const glm::dvec3 to_eye = glm::normalize(eye_ - x);
    const glm::dvec3 want =
        glm::dvec3(0.5, 0.25, 1.0) * exact_sum(map, x, true, [&](const glm::dvec3& l) {
          const double half = std::max(glm::dot(n, glm::normalize(l + to_eye)), 0.0);
          return c * std::pow(half, 5) * std::max(glm::dot(n, l), 0.0);
        });
    for (int k = 0; k < 3; ++k) ASSERT_NEAR(found[i][k], want[k], 2e-3 * want[k] + 2e-5) << i;
  }
}

// The surfaces' own lobe, as wide as the texel makes it: FDP's and LCM's lobes are looked at once.
TEST_F(CubeMapTest, CosineLobesAreSummedAsWideAsTexels) {
  settings_.glossy = true;
  settings_.probes = 0;
  BallHost host(room, {{{-0.3, -0.5, -0.5}, 1.2}});
  render(host);
  const auto map = exact_map(host.without(std::vector{0u}), host.balls()[0].centre, side());
  const Light found = all("specular");
  for (size_t i = 0; i < found.size(); ++i) {
    const glm::dvec3 x = position(i), n = normal(i);
    if (g_.depth[i] == 0 || !host.ball_at(x)) continue;
    const glm::dvec3 mirrored = glm::reflect(glm::normalize(x - eye_), n);
    const auto phong = [&](const glm::dvec3& l, double solid_angle) {
      const double exponent = 1 / (1 / double{kLobe.exponent} + 0.5 * solid_angle / kPi);
      return (exponent + 2) / (2 * kPi) * std::pow(std::max(glm::dot(mirrored, l), 0.0), exponent) *
             std::max(glm::dot(n, l), 0.0);
    };
    const glm::dvec3 want = glm::dvec3(0.5, 0.25, 1.0) * exact_sum(map, x, true, phong);
    for (int k = 0; k < 3; ++k) ASSERT_NEAR(found[i][k], want[k], 2e-3 * want[k] + 2e-4) << i;
  }
}

// A lobe that reflects all of radiance 1 gives its colour.
TEST_F(CubeMapTest, ClassicalGlossKeepsAFurnacesRadiance) {
  settings_.method = Settings::Method::classical;
  settings_.glossy = true;
  settings_.probes = 0;
  BallHost host(furnace, {{{0.3, 0.2, 0}, 1.0}});
  render(host);
  const Light found = all("specular");
  for (size_t i = 0; i < found.size(); ++i) {
    const glm::dvec3 want = host.ball_at(position(i)) ? glm::dvec3(0.5, 0.25, 1.0) : glm::dvec3(0);
    for (int k = 0; k < 3; ++k) ASSERT_NEAR(found[i][k], want[k], 2e-3) << i;
  }
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
