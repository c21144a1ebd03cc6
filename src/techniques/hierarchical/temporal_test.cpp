// SPDX-License-Identifier: MIT
// The temporal filter, FDP (6): noise goes, what moved is found again, nothing stays that should
// not.
#include <cmath>

#include "techniques/hierarchical/hierarchical_fixture.h"

namespace lueur {
namespace {

constexpr Extent kMovingExtent{96, 72};
constexpr double kMovingFov = 1.2;

class TemporalTest : public HierarchicalTest {
 protected:
  // Few samples and no filter in space: noise to get rid of.
  static Settings noisy(float temporal) {
    Settings s;
    s.start = Settings::Start::full;
    s.levels = 3;
    s.samples = 4;
    s.sample_growth = 1;
    s.filter = false;
    s.temporal = temporal;
    return s;
  }

  static CpuGBuffer seen_from(const CpuScene& scene, const glm::dvec3& eye) {
    CpuGBuffer g = cast_g_buffer(scene, kMovingExtent, kMovingFov, eye);
    g.motion.assign(g.depth.size(), glm::vec2(0));
    return g;
  }

  // What each pixel shows of a static scene was elsewhere when the eye was at `before`.
  static void add_motion(CpuGBuffer& g, const glm::dvec3& eye, const glm::dvec3& before) {
    const double tan_v = std::tan(kMovingFov / 2),
                 tan_h = tan_v * kMovingExtent.width / kMovingExtent.height;
    for (size_t i = 0; i < g.depth.size(); ++i) {
      const glm::dvec3 now = g.position_view[i], then = now + eye - before;
      const auto uv = [&](const glm::dvec3& p) {
        return glm::dvec2(0.5 + 0.5 * p.x / -p.z / tan_h, 0.5 - 0.5 * p.y / -p.z / tan_v);
      };
      g.motion[i] = glm::vec2(uv(now) - uv(then));
    }
  }

  // The mean of many frames: what the noise hides.
  Light truth_of(const CpuGBuffer& g, Settings settings = noisy(0)) {
    settings.temporal = 0;
    Hierarchical technique(settings);
    Light mean(g.depth.size(), glm::dvec3(0));
    constexpr uint32_t kFrames = 128;
    for (uint32_t i = 0; i < kFrames; ++i) {
      const Light light = next_frame(technique, g, {.seed = 1000 + i}).diffuse;
      for (size_t k = 0; k < mean.size(); ++k) mean[k] += light[k] / double{kFrames};
    }
    return mean;
  }
};

TEST_F(TemporalTest, AStillCameraConverges) {
  const CpuGBuffer g = seen_from(corner_room, {0.5, 0.2, 0.5});
  const Light truth = truth_of(g);
  Hierarchical technique(noisy(0.95f));
  std::vector<Light> frames;
  for (uint32_t i = 0; i < 60; ++i)
    frames.push_back(
        next_frame(technique, g, {.seed = i, .previous_view = g.view, .cut = i == 0}).diffuse);
  const double first = relative_rmse(frames.front(), truth);
  // A share a of unrelated frames leaves sqrt((1 - a) / (1 + a)) = 0.16 of their noise; these lie
  // evenly and leave less.
  EXPECT_LT(relative_rmse(frames.back(), truth), 0.16 * first);
  // Unrelated frames, which differ by sqrt(2) of their error, then do so by (1 - a) / sqrt(1 + a) =
  // 1/28 of that.
  EXPECT_LT(relative_rmse(frames[59], frames[58]), std::sqrt(2.0) * first / 20);
}

// The eye moves by 2 pixels a frame. Were the motion's sign wrong, or missing, the light of edges
// would be smeared over.
TEST_F(TemporalTest, AMovingCameraTakesItsLightAlong) {
  const auto eye = [](int frame) { return glm::dvec3(0.5 - 0.06 * frame, 0.2, 0.5); };
  constexpr int kFrames = 12;
  CpuGBuffer g;
  Hierarchical filtered(noisy(0.9f));
  Light light;
  for (int i = 0; i < kFrames; ++i) {
    const CpuGBuffer before = g;
    g = seen_from(corner_room, eye(i));
    if (i > 0) add_motion(g, eye(i), eye(i - 1));
    light =
        next_frame(filtered, g,
                   {.seed = static_cast<uint32_t>(i), .previous_view = before.view, .cut = i == 0})
            .diffuse;
  }
  const Light truth = truth_of(g);
  const double unfiltered = relative_rmse(diffuse(g, noisy(0), 3), truth);
  EXPECT_LT(relative_rmse(light, truth), unfiltered / 2);
}

// A near wall goes: what it hid is unknown, and gets nothing of the wall's light.
TEST_F(TemporalTest, WhatIsUncoveredKeepsNothing) {
  const CpuScene before = [](const glm::dvec3& o, const glm::dvec3& d) -> std::optional<CpuHit> {
    const glm::dvec3 p = o + (-1.0 / d.z) * d;
    if (p.x > 0) return CpuHit{p, {0, 0, 1}, glm::dvec3(100.0)};
    return corner_room(o, d);
  };
  const CpuGBuffer near = seen_from(before, {0.5, 0.2, 0.5});
  const CpuGBuffer far = seen_from(corner_room, {0.5, 0.2, 0.5});
  Hierarchical technique(noisy(0.9f));
  for (uint32_t i = 0; i < 8; ++i)
    next_frame(technique, near, {.seed = i, .previous_view = near.view, .cut = i == 0});
  const Light after = next_frame(technique, far, {.seed = 8, .previous_view = near.view}).diffuse;
  const Light fresh = diffuse(far, noisy(0), 8);
  int uncovered = 0;
  for (size_t i = 0; i < fresh.size(); ++i) {
    if (near.depth[i] == far.depth[i]) continue;
    ++uncovered;
    ASSERT_EQ(after[i], fresh[i]) << "pixel " << i;
  }
  EXPECT_GT(uncovered, 1000);
}

TEST_F(TemporalTest, ACutLeavesNothing) {
  CpuGBuffer bright = seen_from(corner_room, {0.5, 0.2, 0.5});
  CpuGBuffer dark = bright;
  dark.source.assign(dark.source.size(), glm::vec3(0));
  Hierarchical technique(noisy(0.9f));
  for (uint32_t i = 0; i < 4; ++i)
    next_frame(technique, bright, {.seed = i, .previous_view = bright.view, .cut = i == 0});
  const Light kept = next_frame(technique, dark, {.previous_view = bright.view}).diffuse;
  EXPECT_GT(relative_rmse(kept, Light(kept.size(), glm::dvec3(1e-3))), 1.0);
  for (const glm::dvec3& l :
       next_frame(technique, dark, {.previous_view = bright.view, .cut = true}).diffuse)
    ASSERT_EQ(l, glm::dvec3(0));
}

// Light that goes out: the clamp takes it away at once, the plain filter as slowly as it averages.
TEST_F(TemporalTest, TheClampFollowsLightThatChanges) {
  CpuGBuffer bright = seen_from(corner_room, {0.5, 0.2, 0.5});
  CpuGBuffer dark = bright;
  for (glm::vec3& s : dark.source) s *= 0.1f;
  for (const bool clamped : {false, true}) {
    Settings s = noisy(0.9f);
    s.filter = true;
    s.temporal_clamp = clamped;
    Hierarchical technique(s);
    for (uint32_t i = 0; i < 30; ++i)
      next_frame(technique, bright, {.seed = i, .previous_view = bright.view, .cut = i == 0});
    const Light after = next_frame(technique, dark, {.previous_view = bright.view}).diffuse;
    double mean = 0, fresh = 0;
    for (const glm::dvec3& l : after) mean += l.x;
    for (const glm::dvec3& l : diffuse(dark, s)) fresh += l.x;
    if (clamped)
      EXPECT_LT(mean / fresh, 2.0);
    else
      EXPECT_GT(mean / fresh, 8.0);  // 0.9 * 10 + 0.1
  }
}

TEST_F(TemporalTest, NoMotionNoMemory) {
  CpuGBuffer g = seen_from(corner_room, {0.5, 0.2, 0.5});
  g.motion.clear();
  Hierarchical technique(noisy(0.9f));
  next_frame(technique, g, {.seed = 1, .previous_view = g.view});
  EXPECT_EQ(next_frame(technique, g, {.seed = 2, .previous_view = g.view}).diffuse,
            diffuse(g, noisy(0), 2));
}

// A board beside a bright floor, before a dim wall; its left edge's place in metres.
CpuScene board_at(double left) {
  return [left](const glm::dvec3& o, const glm::dvec3& d) -> std::optional<CpuHit> {
    const glm::dvec3 board = o + (-2.0 / d.z) * d;
    if (board.x > left && board.x < left + 1.2 && board.y < 0.6 && board.y > -1)
      return CpuHit{board, {0, 0, 1}, glm::dvec3(0)};
    const double t_wall = -5.0 / d.z, t_floor = d.y < 0 ? (-1 - o.y) / d.y : 1e30;
    if (t_wall < t_floor) return CpuHit{o + t_wall * d, {0, 0, 1}, glm::dvec3(0.05)};
    const glm::dvec3 p = o + t_floor * d;
    return CpuHit{p, {0, 1, 0}, glm::dvec3(p.z > -2 ? 1.0 : 0.0)};
  };
}

bool is_board(const CpuGBuffer& g, size_t i) {
  return std::abs(g.position_view[i].z + 2) < 1e-3 && g.normal[i].z > 0.5f;
}

class MovingBoardTest : public TemporalTest {
 protected:
  static constexpr int kMovedPx = 2;  // a frame

  // Frame `i` of the board's way, which uncovers the wall at its left.
  void next(Hierarchical& technique, int i) {
    // At 2 m the picture is 4 tan(fov / 2) m high.
    const double pixel_m = 4 * std::tan(kMovingFov / 2) / kMovingExtent.height;
    const CpuGBuffer before = g_;
    g_ = seen_from(board_at(-2 + i * kMovedPx * pixel_m), {0, 0, 0});
    for (size_t k = 0; k < age_.size(); ++k) {
      if (is_board(g_, k)) g_.motion[k] = {float(kMovedPx) / float(kMovingExtent.width), 0};
      if (age_[k] >= 0) ++age_[k];
      if (i > 0 && is_board(before, k) && !is_board(g_, k)) age_[k] = 0;
    }
    light_ = next_frame(technique, g_,
                        {.seed = static_cast<uint32_t>(i), .previous_view = g_.view, .cut = i == 0})
                 .diffuse;
  }

  // Over what was uncovered `youngest` to `oldest` frames ago, or over the board.
  double mean_uncovered(const Light& light, int youngest, int oldest) const {
    return mean_where(light, [&](size_t k) { return age_[k] >= youngest && age_[k] <= oldest; });
  }
  double mean_board(const Light& light) const {
    return mean_where(light, [&](size_t k) { return is_board(g_, k); });
  }

  CpuGBuffer g_;
  Light light_;

 private:
  template <class Where>
  double mean_where(const Light& light, Where where) const {
    double sum = 0, count = 0;
    for (size_t k = 0; k < light.size(); ++k)
      if (where(k)) {
        sum += light[k].x;
        ++count;
      }
    EXPECT_GT(count, 50);
    return sum / count;
  }

  std::vector<int> age_ = std::vector<int>(size_t{kMovingExtent.width} * kMovingExtent.height, -1);
};

// Where the board has been, 8 frames ago and since, no more of its light is left than 2 %.
TEST_F(MovingBoardTest, NothingStaysBehindIt) {
  for (const auto start : {Settings::Start::full, Settings::Start::half}) {
    Settings s = noisy(0.9f);
    s.start = start;
    Hierarchical technique(s);
    for (int i = 0; i < 24; ++i) next(technique, i);
    const Light truth = truth_of(g_, s);
    EXPECT_LT(std::abs(mean_uncovered(light_, 0, 8) - mean_uncovered(truth, 0, 8)),
              0.02 * mean_board(truth))
        << (start == Settings::Start::full ? "full" : "half");
  }
}

}  // namespace
}  // namespace lueur
