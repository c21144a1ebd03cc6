// SPDX-License-Identifier: MIT
// What the technique's tests share: an engine with balls that move, and LCM's sums in double
// precision over the same pictures.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>
#include <type_traits>
#include <vector>

#include "lueur/cube_map.h"
#include "support/gpu_test.h"

namespace lueur {

inline constexpr uint32_t kPicturePx = 64;
inline constexpr CosineLobe kLobe{.exponent = 6.0f};  // of all surfaces
inline const Box kRoomBounds{{-3, -2, -3}, {3, 2, 3}};
inline const double kFar = 2 * std::sqrt(36.0 + 16.0 + 36.0);

// The inside of a sphere of radius 4 and radiance 1.
std::optional<CpuHit> furnace(const glm::dvec3& o, const glm::dvec3& d);
// A room of 6 x 4 x 6 m whose sides glow in different colours, open at the front.
std::optional<CpuHit> room(const glm::dvec3& o, const glm::dvec3& d);

struct Ball {
  glm::dvec3 centre;
  double radius;
};

// Where a ray meets it from outside, in lengths of `d`.
std::optional<double> meet(const Ball& ball, const glm::dvec3& o, const glm::dvec3& d);

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

std::vector<ExactTexel> exact_map(const CpuScene& scene, const glm::dvec3& centre, uint32_t side);

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
  using Settings = CubeMapSettings;
  using Light = std::vector<glm::dvec3>;  // a value a pixel

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

}  // namespace lueur
