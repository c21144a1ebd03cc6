// SPDX-License-Identifier: MIT
#include "scene/builtin/dragon.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "scene/builtin/sdf.h"

namespace lueur::builtin {
namespace {

using glm::vec3;

// A place on the spine, from the tail's tip to the neck.
struct Vertebra {
  vec3 position;
  vec3 back;       // unit length, towards the ridge of the back
  float radius;    // of the body
  float length_m;  // from the tip
};

// Controls of the spine: one turn on the floor, from its end up over the coil, and the neck's bow.
std::vector<Vertebra> spine_controls() {
  std::vector<Vertebra> controls;
  constexpr int kAround = 21;
  for (int k = 0; k <= kAround; ++k) {
    const float share = float(k) / kAround;
    const float angle = kPi * (0.42f - 2.92f * share);  // from the front, once and a half around
    const float radius = 0.012f + 0.100f * std::pow(share, 0.62f);
    const float ring = 0.51f - 0.17f * share - 0.21f * glm::smoothstep(0.74f, 1.0f, share);
    const float height = radius + 0.07f * glm::smoothstep(0.10f, 0.0f, share) +
                         0.24f * glm::smoothstep(0.70f, 1.0f, share);
    controls.push_back(
        {{ring * std::cos(angle), height, ring * std::sin(angle)}, {0, 1, 0}, radius, 0});
  }
  controls.push_back({{-0.05f, 0.43f, -0.18f}, glm::normalize(vec3(0, 0.5f, -1)), 0.116f, 0});
  controls.push_back({{0, 0.55f, -0.17f}, {0, 0.1f, -1}, 0.108f, 0});
  controls.push_back({{0, 0.66f, -0.10f}, {0, 0.25f, -1}, 0.088f, 0});
  controls.push_back({{0, 0.79f, -0.04f}, {0, 0.2f, -1}, 0.074f, 0});
  controls.push_back({{0, 0.90f, 0.00f}, {0, 0.6f, -1}, 0.066f, 0});
  controls.push_back({{0, 0.955f, 0.07f}, {0, 1, -0.6f}, 0.062f, 0});
  return controls;
}

// The frame of the head, where the neck ends.
constexpr vec3 kHead{0, 0.955f, 0.125f};
constexpr float kHeadDown = 0.32f;  // rad

class Dragon {
 public:
  Dragon() {
    // Smooth the controls (Catmull and Rom), then measure.
    const std::vector<Vertebra> controls = spine_controls();
    const int last = int(controls.size()) - 1;
    const auto at = [&](int k) { return controls[std::clamp(k, 0, last)]; };
    constexpr int kSteps = 6;
    for (int k = 0; k < last; ++k)
      for (int step = 0; step < kSteps; ++step)
        spine_.push_back(between(at(k - 1), at(k), at(k + 1), at(k + 2), float(step) / kSteps));
    spine_.push_back(controls.back());
    for (size_t k = 1; k < spine_.size(); ++k)
      spine_[k].length_m =
          spine_[k - 1].length_m + glm::distance(spine_[k - 1].position, spine_[k].position);
    bound_runs();
    place_spikes();
  }

  float distance(vec3 p) const {
    float d = body(p);
    d = join(d, p, {0, 0.55f, -0.30f}, 0.95f, 0.03f, [&] { return dragon_wings(p); });
    d = join(d, p, kHead, 0.44f, 0.035f, [&] {
      const float c = std::cos(kHeadDown), s = std::sin(kHeadDown);
      const vec3 q = p - kHead;
      return dragon_head({q.x, c * q.y + s * q.z, c * q.z - s * q.y});
    });
    d = join(d, p, {0, 0.35f, 0.02f}, 0.36f, 0.03f, [&] { return arms(p); });
    return d;
  }

 private:
  struct Run {  // of segments, in a ball
    size_t first, last;
    vec3 center;
    float radius;
  };
  struct Spike {
    vec3 foot, tip;
    float radius;
    vec3 center;  // of a ball around it
    float reach;
  };

  static Vertebra between(const Vertebra& a, const Vertebra& b, const Vertebra& c,
                          const Vertebra& d, float t) {
    const auto smooth = [t](const auto& w, const auto& x, const auto& y, const auto& z) {
      return x + 0.5f * t *
                     ((y - w) +
                      t * (2.0f * w - 5.0f * x + 4.0f * y - z + t * (3.0f * (x - y) + z - w)));
    };
    return {smooth(a.position, b.position, c.position, d.position),
            glm::normalize(smooth(a.back, b.back, c.back, d.back)),
            smooth(a.radius, b.radius, c.radius, d.radius), 0};
  }

  void bound_runs() {
    constexpr size_t kRun = 6;
    for (size_t first = 0; first + 1 < spine_.size(); first += kRun) {
      Run run{first, std::min(first + kRun, spine_.size() - 1), {}, 0};
      run.center = 0.5f * (spine_[run.first].position + spine_[run.last].position);
      for (size_t k = run.first; k <= run.last; ++k)
        run.radius = std::max(
            run.radius, glm::distance(run.center, spine_[k].position) + spine_[k].radius + kRelief);
      runs_.push_back(run);
    }
  }

  // A spike each 7 cm of the ridge, swept back; small at the tail and behind the head.
  void place_spikes() {
    float next = 0.25f;
    const float whole = spine_.back().length_m;
    for (size_t k = 1; k < spine_.size(); ++k) {
      const Vertebra& v = spine_[k];
      if (v.length_m < next || v.length_m > whole - 0.05f) continue;
      next += 0.062f;
      const vec3 along = glm::normalize(v.position - spine_[k - 1].position);
      const vec3 back = glm::normalize(v.back - along * glm::dot(v.back, along));
      const float size = 0.35f + 0.65f * std::sin(kPi * std::sqrt(v.length_m / whole));
      Spike spike{v.position + back * (0.85f * v.radius),
                  v.position + back * (v.radius + 0.085f * size) - along * (0.06f * size),
                  0.014f + 0.014f * size,
                  {},
                  0};
      spike.center = 0.5f * (spike.foot + spike.tip);
      spike.reach = 0.5f * glm::distance(spike.foot, spike.tip) + spike.radius;
      spikes_.push_back(spike);
    }
  }

  // The union with a part inside a ball, skipped where the ball is farther than what is there.
  template <class Part>
  static float join(float d, vec3 p, vec3 center, float radius, float width, Part&& part) {
    const float far = glm::distance(p, center) - radius;
    return far > d + width ? d : far > 0.2f ? std::min(d, far) : sdf::smooth_min(d, part(), width);
  }

  float body(vec3 p) const {
    // Find the nearest point of the spine.
    float nearest = 1e9f, share = 0.0f;
    size_t segment = 0;
    const auto from_run = [&](const Run& run) { return glm::distance(p, run.center) - run.radius; };
    const auto search = [&](const Run& run) {
      for (size_t k = run.first; k < run.last; ++k) {
        const Vertebra &a = spine_[k], &b = spine_[k + 1];
        const float s = sdf::segment_share(p, a.position, b.position);
        const float d =
            glm::distance(p, glm::mix(a.position, b.position, s)) - glm::mix(a.radius, b.radius, s);
        if (d >= nearest) continue;
        nearest = d;
        segment = k;
        share = s;
      }
    };
    const auto first =
        std::min_element(runs_.begin(), runs_.end(),
                         [&](const Run& a, const Run& b) { return from_run(a) < from_run(b); });
    search(*first);
    for (auto run = runs_.begin(); run != runs_.end(); ++run)
      if (run != first && from_run(*run) <= nearest) search(*run);
    if (nearest > 0.2f) return nearest - kProud;  // nothing stands out that far
    const Vertebra &a = spine_[segment], &b = spine_[segment + 1];
    const vec3 along = glm::normalize(b.position - a.position);
    vec3 back = glm::mix(a.back, b.back, share);
    back = glm::normalize(back - along * glm::dot(back, along));
    const vec3 from = p - glm::mix(a.position, b.position, share);
    const float turn = std::atan2(glm::dot(from, glm::cross(along, back)), glm::dot(from, back));
    const float thick = glm::mix(a.radius, b.radius, share);
    nearest -= relief(glm::mix(a.length_m, b.length_m, share), turn) *
               glm::smoothstep(0.02f, 0.06f, thick);
    for (const Spike& spike : spikes_) {
      if (glm::distance(p, spike.center) - spike.reach > nearest + kFillet) continue;
      nearest = sdf::smooth_min(nearest, sdf::cone(p, spike.foot, spike.tip, spike.radius, 0.005f),
                                kFillet);
    }
    return nearest;
  }

  // What stands out of the skin `length_m` from the tail's tip, at `turn` from the ridge: plates
  // across the belly, elsewhere scales that lie on each other like tiles.
  static float relief(float length_m, float turn) {
    const float side = std::abs(turn) / kPi;  // 1 under the belly
    const float plate = glm::fract(-length_m / 0.05f);
    const float belly = 0.9f * std::min(plate * 1.25f, (1.0f - plate) * 5.0f);
    constexpr float kAround = 10.0f, kLong = 0.088f;
    const float a = turn / (2 * kPi) * kAround, b = length_m / kLong;
    const float u = glm::fract(a + b), v = glm::fract(b - a);  // both grow towards the head
    const float edge = std::min(std::min(u, 1 - u), std::min(v, 1 - v));
    const float scale = glm::smoothstep(0.0f, 0.22f, edge) * (1.15f - 0.42f * (u + v));
    return kRelief * glm::mix(scale, belly, glm::smoothstep(0.68f, 0.74f, side));
  }

  // Arms that rest on the coil, three claws each.
  static float arms(vec3 p) {
    p.x = std::abs(p.x);
    const vec3 shoulder(0.07f, 0.50f, -0.12f), elbow(0.215f, 0.385f, 0.00f);
    const vec3 hand(0.165f, 0.245f, 0.235f);
    float d = sdf::cone(p, shoulder, elbow, 0.066f, 0.044f);
    d = sdf::smooth_min(d, sdf::cone(p, elbow, hand, 0.042f, 0.030f), 0.02f);
    d = sdf::smooth_min(d, sdf::ellipsoid(p, hand, {0.045f, 0.026f, 0.045f}), 0.015f);
    for (int k = -1; k <= 1; ++k) {
      const vec3 knuckle = hand + vec3(0.036f * float(k), 0.010f, 0.062f - 0.012f * float(k * k));
      const vec3 tip = knuckle + vec3(0.020f * float(k), -0.055f, 0.052f);
      d = sdf::smooth_min(d, sdf::cone(p, hand, knuckle, 0.022f, 0.017f), 0.012f);
      d = sdf::smooth_min(d, sdf::cone(p, knuckle, tip, 0.017f, 0.005f), 0.008f);
    }
    return sdf::smooth_min(
        d, sdf::cone(p, elbow, elbow + vec3(0.05f, 0.03f, -0.07f), 0.02f, 0.004f), 0.02f);
  }

  static constexpr float kRelief = 0.011f;  // m: height of scales and plates
  static constexpr float kFillet = 0.012f;  // m: at the foot of a spike
  static constexpr float kProud = 0.12f;    // m: a spike is shorter

  std::vector<Vertebra> spine_;
  std::vector<Run> runs_;
  std::vector<Spike> spikes_;
};

}  // namespace

Isosurface dragon_surface() {
  return {.distance = [dragon = Dragon()](vec3 p) { return dragon.distance(p); },
          .steepness = 1.5f,
          .min = {-0.75f, -0.05f, -0.65f},
          .max = {0.75f, 1.35f, 0.65f}};
}

void add_dragon(MeshBuilder& builder, uint32_t triangles) {
  add_isosurface_of(builder, dragon_surface(), triangles);
}

}  // namespace lueur::builtin
