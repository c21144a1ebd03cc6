// SPDX-License-Identifier: MIT
// The same bits for any number of threads and interruptions, and honest errors.
#include <cmath>

#include "reference/reference_fixture.h"
#include "scene/builtin/scene_builder.h"

namespace lueur::reference {
namespace {

// Two columns and rows of tiles, none of them whole.
constexpr Shot kOdd{29, 21};

// A box with everything that takes random numbers: several lights, emitters, gloss, long paths.
Scene scene() {
  Scene scene = inside_box();
  scene.materials[0].base_color = glm::vec4(0.7f, 0.6f, 0.5f, 1);
  scene.materials[0].specular = 1.0f;
  scene.materials[0].roughness = 0.5f;
  add_quad(scene, {-0.5f, 0.95f, 0.5f}, {1, 0, 0}, {0, 0, -1}, add_diffuse(scene, 0.2f, 2));
  add_light(scene, LightKind::point, 0.5f, {0.5f, 0.5f, -0.5f});
  add_light(scene, LightKind::point, 0.2f, {-0.5f, -0.5f, 0.5f});
  return scene;
}

struct Case {
  const char* name;
  Settings settings;
};
void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}
class ResumeTest : public testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(Modes, ResumeTest,
                         testing::Values(Case{"path", {.bounces = 6, .spp = 64}},
                                         Case{"screen", {.mode = Mode::screen, .spp = 64}},
                                         Case{"unoccluded",
                                              {.mode = Mode::screen_unoccluded, .spp = 0}},
                                         Case{"ambient", {.mode = Mode::ambient, .spp = 64}}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_P(ResumeTest, ThreadsDoNotMatter) {
  const Scene s = scene();
  const Rendering one = rendered(s, kOdd, GetParam().settings, {.threads = 1});
  EXPECT_TRUE(one.complete);
  EXPECT_TRUE(one.state.empty());
  for (const uint32_t threads : {2u, 3u, 7u})
    EXPECT_TRUE(same_layers(one, rendered(s, kOdd, GetParam().settings, {.threads = threads})))
        << threads << " threads";
  Settings other = GetParam().settings;
  ++other.seed;
  // All pixels make one sum, in whatever order.
  if (other.mode != Mode::screen_unoccluded) {
    EXPECT_FALSE(same_layers(one, rendered(s, kOdd, other)));
  }
}

// Stops when `passes` passes are done.
Rendering stopped_after(const Scene& s, const Settings& settings, uint32_t passes,
                        std::span<const uint8_t> state = {}) {
  std::stop_source stop;
  uint32_t reports = 0;
  Control control{.threads = 2,
                  .progress =
                      [&](const Progress&) {
                        // The first report comes before the first pass.
                        if (reports++ == passes) stop.request_stop();
                      },
                  .stop = stop.get_token()};
  return rendered(s, kOdd, settings, control, state);
}

TEST_P(ResumeTest, GoesOnToTheSameBits) {
  const Scene s = scene();
  const Settings settings = GetParam().settings;
  const Rendering whole = rendered(s, kOdd, settings);
  for (const uint32_t passes : {0u, 1u, 2u}) {
    if (passes * kSamplesPerPass >= whole.progress.spp_done) continue;
    const Rendering part = stopped_after(s, settings, passes);
    ASSERT_FALSE(part.complete) << passes;
    ASSERT_FALSE(part.state.empty());
    EXPECT_FALSE(same_layers(part, whole));
    // Once more on the way.
    const Rendering further = stopped_after(s, settings, passes == 1 ? 1 : 0, part.state);
    ASSERT_FALSE(further.complete);
    const Rendering end = rendered(s, kOdd, settings, {.threads = 3}, further.state);
    EXPECT_TRUE(end.complete);
    EXPECT_EQ(end.progress.spp_done, whole.progress.spp_done);
    EXPECT_EQ(end.progress.relative_error, whole.progress.relative_error);
    EXPECT_TRUE(same_layers(end, whole)) << "after " << passes << " passes";
  }
}

TEST(Resume, GoesOnToMoreSamples) {
  const Scene s = scene();
  const Settings few{.bounces = 3, .spp = 64}, many{.bounces = 3, .spp = 128};
  const Rendering part = stopped_after(s, few, 2);
  EXPECT_EQ(part.progress.spp_done, 2 * kSamplesPerPass);
  EXPECT_TRUE(same_layers(rendered(s, kOdd, many, {}, part.state), rendered(s, kOdd, many)));
}

TEST(Resume, CheckpointsAreStates) {
  const Scene s = scene();
  const Settings settings{.spp = 5 * kSamplesPerPass};
  std::vector<std::vector<uint8_t>> states;
  Control control{.checkpoint = [&](const std::vector<uint8_t>& state) { states.push_back(state); },
                  .checkpoint_s = 0};
  const Rendering whole = rendered(s, kOdd, settings, control);
  ASSERT_EQ(states.size(), 5u);
  for (const auto& state : states)
    EXPECT_TRUE(same_layers(rendered(s, kOdd, settings, {}, state), whole));
}

void expect_refused(const Scene& s, const Shot& shot, const Settings& settings,
                    std::span<const uint8_t> state, const std::string& why) {
  const auto r = render(s, shot, settings, {}, state);
  ASSERT_FALSE(r.ok()) << why;
  EXPECT_EQ(r.error().kind, ErrorKind::input);
  EXPECT_NE(r.error().message.find(why), std::string::npos) << r.error().message;
  EXPECT_EQ(r.error().message.find('\n'), std::string::npos);
}

TEST(Resume, RefusesWhatItDoesNotFit) {
  const Scene s = scene();
  const Settings settings{.bounces = 2, .spp = 64};
  const std::vector<uint8_t> state = stopped_after(s, settings, 2).state;

  Scene brighter = s;
  brighter.lights[0].intensity *= 2;
  expect_refused(brighter, kOdd, settings, state, "another");
  expect_refused(s, {kOdd.width, kOdd.height + 1}, settings, state, "another");
  Settings other = settings;
  other.bounces = 3;
  expect_refused(s, kOdd, other, state, "another");
  other = settings;
  other.seed = 9;
  expect_refused(s, kOdd, other, state, "another");

  for (const size_t bytes : {size_t{1}, size_t{7}, size_t{40}, state.size() / 2, state.size() - 1})
    expect_refused(s, kOdd, settings, std::span(state).first(bytes), "damaged");
  std::vector<uint8_t> longer = state;
  longer.push_back(0);
  expect_refused(s, kOdd, settings, longer, "damaged");
  expect_refused(s, kOdd, settings, std::vector<uint8_t>(200, 'x'), "not a reference's");
}

TEST(Resume, RefusesAnyFlippedBit) {
  const Scene s = scene();
  const Settings settings{.spp = 64};
  const std::vector<uint8_t> state = stopped_after(s, settings, 1).state;
  // All of the head and the checksum, and some of the sums.
  for (size_t byte = 0; byte < state.size();
       byte += byte < 64 || byte + 9 > state.size() ? 1 : 4099) {
    std::vector<uint8_t> damaged = state;
    damaged[byte] = static_cast<uint8_t>(damaged[byte] ^ (1u << (byte % 8)));
    const auto r = render(s, kOdd, settings, {}, damaged);
    ASSERT_FALSE(r.ok()) << "byte " << byte;
    EXPECT_EQ(r.error().kind, ErrorKind::input);
  }
}

// The estimate is of the root mean square over the picture, so it can be held against it where the
// truth is known: 2 (1 + 0.7 + 0.49) in a closed room.
TEST(TargetError, StopsAndIsHonest) {
  Scene s = inside_sphere();
  s.materials[0].base_color = glm::vec4(glm::vec3(0.7f), 1);
  s.materials[0].emission = glm::vec3(2);
  const double f = static_cast<double>(0.7f), exact = 2 * (1 + f + f * f);
  for (const double target : {0.003, 0.0015}) {
    const Settings settings{.bounces = 3, .spp = 1u << 14, .target_error = target};
    const Rendering r = rendered(s, kOdd, settings);
    EXPECT_TRUE(r.complete);
    EXPECT_LT(r.progress.spp_done, r.progress.spp_total);
    EXPECT_LE(r.progress.relative_error, target);
    const ImageF &indirect = layer(r, "indirect"), &variance = layer(r, "variance");
    double squares = 0, estimated = 0;
    for (size_t i = 0; i < indirect.samples.size(); i += 3) {
      squares += std::pow(static_cast<double>(indirect.samples[i]) - exact, 2);
      estimated += static_cast<double>(variance.samples[i]);
    }
    const double n = kOdd.width * kOdd.height;
    const double error = std::sqrt(squares / n) / exact;
    // 609 pixels give the root mean square itself to 1 / sqrt(2 * 609) = 3 %.
    EXPECT_LE(error, 1.2 * r.progress.relative_error);
    // Strata make the truth better than the estimate, but not by much: paths have many dimensions.
    EXPECT_GE(error, 0.5 * r.progress.relative_error);
    RecordProperty("true_over_estimated_at_" + std::to_string(target),
                   std::to_string(error / r.progress.relative_error));
    // The layer says the same as the number, up to what the mean and rounding do.
    EXPECT_NEAR(std::sqrt(estimated / n) / exact, r.progress.relative_error,
                0.02 * r.progress.relative_error);
  }
}

TEST(TargetError, ReportsCountUp) {
  const Scene s = scene();
  std::vector<Progress> reports;
  const Control control{.progress = [&](const Progress& p) { reports.push_back(p); }};
  rendered(s, kOdd, {.spp = 4 * kSamplesPerPass - 1}, control);
  ASSERT_EQ(reports.size(), 5u);
  for (uint32_t k = 0; k < 5; ++k) {
    EXPECT_EQ(reports[k].spp_done, kSamplesPerPass * k);
    EXPECT_EQ(reports[k].spp_total, 4 * kSamplesPerPass);
    EXPECT_EQ(std::isfinite(reports[k].relative_error), k >= 2);
    if (k > 0) {
      EXPECT_GT(reports[k].rays, reports[k - 1].rays);
    }
  }
}

}  // namespace
}  // namespace lueur::reference
