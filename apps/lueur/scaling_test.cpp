// SPDX-License-Identifier: MIT
#include "scaling.h"

#include <gtest/gtest.h>

#include "lueur/hierarchical.h"

namespace lueur::cli {
namespace {

using Texts = std::vector<std::string>;
constexpr Extent kSize{1280, 720};

Texts values_of(const std::string& text, Extent size = kSize) {
  const auto scale = parse_scale("--scale", text, size);
  EXPECT_TRUE(scale.ok()) << text;
  return scale.ok() ? scale->values : Texts();
}

CandidateRequest atrium() {
  auto technique = choose_technique("hierarchical", {});
  return {"base", "atrium", kSize, std::move(*technique)};
}

TEST(Scaling, DefaultsAndGivenValues) {
  EXPECT_EQ(values_of("samples"), (Texts{"8", "16", "32", "64", "128", "256"}));
  EXPECT_EQ(values_of("samples=4,8"), (Texts{"4", "8"}));
  EXPECT_EQ(values_of("radius=7.5"), Texts{"7.5"});
  EXPECT_EQ(values_of("pixels"),
            (Texts{"320x180", "480x270", "640x360", "960x540", "1280x720", "1920x1080"}));
  EXPECT_EQ(values_of("pixels", {10, 1}).front(), "3x1");  // no side below 1
}

TEST(Scaling, EveryDefaultIsAValue) {
  for (const char* of : {"pixels", "triangles", "samples", "levels"}) {
    const auto scale = parse_scale("--scale", of, kSize);
    ASSERT_TRUE(scale.ok()) << of;
    for (const std::string& value : scale->values)
      EXPECT_TRUE(at_value(*scale, value, atrium()).ok()) << of << " " << value;
  }
}

TEST(Scaling, ErrorsNameTheFlag) {
  for (const char* text : {"", "radius", "samples=8,16,8", "=1,1"}) {
    const auto scale = parse_scale("--scale", text, kSize);
    ASSERT_FALSE(scale.ok()) << text;
    EXPECT_EQ(scale.error().kind, ErrorKind::usage);
    EXPECT_TRUE(scale.error().message.starts_with("--scale '")) << scale.error().message;
  }
  const Texts pairs[] = {{"pixels", "12"}, {"triangles", "many"}, {"samples", ""},
                         {"samples", "0"}, {"start", "full"},     {"nothing", "1"}};
  for (const Texts& pair : pairs) {
    const auto request = at_value({"--scale", pair[0], {}}, pair[1], atrium());
    ASSERT_FALSE(request.ok()) << pair[0];
    EXPECT_EQ(request.error().kind, ErrorKind::usage);
    EXPECT_TRUE(request.error().message.starts_with("--scale ")) << request.error().message;
  }
  CandidateRequest cornell = atrium();
  cornell.scene = "cornell";
  EXPECT_FALSE(at_value({"--triangles", "triangles", {}}, "10000", cornell).ok());
  EXPECT_FALSE(at_value({"--scale", "samples", {}}, "8", {"none", "atrium", kSize, {}}).ok());
}

TEST(Scaling, OneThingChanges) {
  const CandidateRequest base = atrium();
  const auto pixels = at_value({"--scale", "pixels", {}}, "64x36", base);
  ASSERT_TRUE(pixels.ok());
  EXPECT_EQ(pixels->size, (Extent{64, 36}));
  EXPECT_EQ(pixels->scene, "atrium");
  EXPECT_EQ(pixels->technique.label, base.technique.label);
  const auto triangles = at_value({"--scale", "triangles", {}}, "20000", base);
  ASSERT_TRUE(triangles.ok());
  EXPECT_EQ(triangles->size, kSize);
  EXPECT_EQ(triangles->scene, "atrium:triangles=20000");
  const auto samples = at_value({"--scale", "samples", {}}, "8", base);
  ASSERT_TRUE(samples.ok());
  const auto settings_of = [](const ChosenTechnique& technique) {
    return *static_cast<const HierarchicalSettings*>(technique.technique->settings());
  };
  EXPECT_EQ(settings_of(samples->technique).samples, 8);
  EXPECT_EQ(settings_of(base.technique).samples, HierarchicalSettings{}.samples);
  EXPECT_NE(samples->label, triangles->label);
}

// Two series: gather grows with the value, combine begins at the second, and the second round is
// ten times slower.
TEST(Scaling, EachGroupOfPassesHasItsOwnFit) {
  const Scale scale{"--scale", "samples", {"2", "4", "8"}};
  std::vector<Candidate> candidates;
  Rounds rounds;
  for (const double factor : {1.0, 10.0}) {
    for (const std::string& value : scale.values) {
      const double x = std::stod(value);
      Candidate candidate;
      auto technique = choose_technique("hierarchical", {"samples=" + value});
      candidate.technique = std::move(*technique);
      candidates.push_back(std::move(candidate));
      std::vector<FrameTimes> frames;
      for (const double slower : {1.0, 10.0, 1.0}) {
        FrameTimes frame;
        frame.passes = {{"hierarchical.gather@1", slower * factor * x * 0.25},
                        {"hierarchical.gather@0", slower * factor * x * 0.75},
                        {"hierarchical.output", slower * 5},
                        {"renderer.light", slower * (95 - factor * x)}};
        if (x > 2) frame.passes.push_back({"renderer.late", slower * 3});
        frame.together = frame.passes;
        frames.push_back(frame);
      }
      rounds.push_back(std::move(frames));
    }
  }
  const Texts labels = {"a", "b"};
  const auto all = fit_series(scale, labels, candidates, rounds);
  ASSERT_EQ(all.size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    const double factor = i == 0 ? 1.0 : 10.0;
    EXPECT_EQ(all[i].technique, labels[i]);
    EXPECT_EQ(all[i].first, 3 * i);
    EXPECT_EQ(all[i].x, (std::vector<double>{2, 4, 8}));
    ASSERT_EQ(all[i].fits.size(), 6u);
    const auto expect_line = [&](size_t fit, const char* group, double constant, double slope) {
      EXPECT_EQ(all[i].fits[fit].group, group);
      EXPECT_NEAR(all[i].fits[fit].line->constant, constant, 1e-9) << group;
      EXPECT_NEAR(all[i].fits[fit].line->slope, slope, 1e-9) << group;
    };
    expect_line(0, "technique", 5, factor);
    EXPECT_EQ(all[i].fits[1].group, "all passes");
    expect_line(2, "hierarchical.gather", 0, factor);
    EXPECT_NEAR(all[i].fits[2].power->exponent, 1.0, 1e-9);
    EXPECT_NEAR(all[i].fits[2].first_ms, factor * 2, 1e-9);
    EXPECT_NEAR(all[i].fits[2].last_ms, factor * 8, 1e-9);
    expect_line(3, "hierarchical.output", 5, 0);
    expect_line(4, "renderer.light", 95, -factor);
    expect_line(5, "renderer.late", 3, 0);
  }
}

}  // namespace
}  // namespace lueur::cli
