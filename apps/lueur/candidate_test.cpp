// SPDX-License-Identifier: MIT
// Candidates that take turns on one device must not see each other.
#include "candidate.h"

#include "session_fixture.h"
#include "timing.h"

namespace lueur::cli {
namespace {

constexpr Extent kSize{64, 36};

class CandidateTest : public SessionTest {
 protected:
  void TearDown() override {
    candidates_.clear();
    SessionTest::TearDown();
  }

  void make(std::vector<CandidateRequest> requests) {
    candidates_.clear();
    auto made = make_candidates(*session_, std::move(requests), "", 0);
    ASSERT_TRUE(made.ok()) << made.error().message;
    candidates_ = std::move(*made);
  }
  static CandidateRequest request(const std::string& technique,
                                  const std::vector<std::string>& settings = {},
                                  Extent size = kSize) {
    auto chosen = choose_technique(technique, settings);
    EXPECT_TRUE(chosen.ok());
    const std::string label = chosen->label + " " + std::to_string(size.width);
    return {label, "cornell", size, std::move(*chosen)};
  }
  std::vector<float> picture(size_t candidate) {
    auto frame = render_candidate(*session_, candidates_[candidate], {"composed"});
    EXPECT_TRUE(frame.ok());
    return frame.ok() ? frame->pixels.at(0).samples : std::vector<float>();
  }

  std::vector<Candidate> candidates_;
};

TEST_F(CandidateTest, TurnsDoNotChangeThePictures) {
  const auto requests = [] {
    std::vector<CandidateRequest> all;
    all.push_back(request("hierarchical"));
    all.push_back(request("none"));
    all.push_back(request("hierarchical", {"samples=8", "start=full"}));
    all.push_back(request("hierarchical", {}, {37, 61}));
    return all;
  };
  std::vector<std::vector<float>> alone;
  for (size_t i = 0; i < requests().size(); ++i) {
    std::vector<CandidateRequest> one;
    one.push_back(std::move(requests()[i]));
    make(std::move(one));
    alone.push_back(picture(0));
  }
  make(requests());
  for (int round = 0; round < 2; ++round)
    for (size_t i = 0; i < candidates_.size(); ++i)
      EXPECT_EQ(picture(i), alone[i]) << candidates_[i].label << ", round " << round;
  // All show one scene, which is on the device once.
  for (const Candidate& candidate : candidates_) EXPECT_EQ(candidate.scene, candidates_[0].scene);
}

TEST_F(CandidateTest, EachRemembersItsOwnLastFrame) {
  std::vector<CandidateRequest> requests;
  requests.push_back(request("none"));
  requests.push_back(request("none", {}, {37, 61}));
  make(std::move(requests));
  std::vector<Remembering*> techniques;
  for (Candidate& candidate : candidates_) {
    auto technique = std::make_unique<Remembering>();
    techniques.push_back(technique.get());
    candidate.technique.technique = std::move(technique);
  }
  ASSERT_TRUE(time_in_turn(*session_, candidates_, 2).ok());
  std::vector<bool> expected(2 + 2 * 2, true);
  expected[0] = false;  // nothing to remember yet
  for (const Remembering* technique : techniques) EXPECT_EQ(technique->remembered, expected);
}

TEST_F(CandidateTest, MemoryIsTheCandidatesOwn) {
  const auto two = [](bool turned) {
    std::vector<CandidateRequest> all;
    all.push_back(request("hierarchical", {}, {256, 128}));
    all.push_back(request("none", {}, {256, 128}));
    all.push_back(request("hierarchical", {"start=full"}, {256, 128}));
    if (turned) std::swap(all[0], all[2]);
    return all;
  };
  make(two(false));
  // The technique's header: about 29 bytes a pixel at half start with its memory of the last frame;
  // the renderer makes 8 more of reflectance for it. Small levels are padded.
  const double bytes_per_pixel =
      static_cast<double>(candidates_[0].memory.technique) / (256.0 * 128.0);
  EXPECT_NEAR(bytes_per_pixel, 29.0 + 8.0, 4.0);
  EXPECT_EQ(candidates_[1].memory.technique, 0u);
  EXPECT_GT(candidates_[2].memory.technique, candidates_[0].memory.technique);
  for (const Candidate& candidate : candidates_)
    EXPECT_EQ(candidate.memory.total - candidate.memory.technique, candidates_[1].memory.total);
  EXPECT_GT(candidates_[1].memory.total, candidates_[1].scene->bytes);

  // Who came before does not count.
  const CandidateMemory half = candidates_[0].memory, full = candidates_[2].memory;
  make(two(true));
  EXPECT_EQ(candidates_[0].memory.technique, full.technique);
  EXPECT_EQ(candidates_[0].memory.total, full.total);
  EXPECT_EQ(candidates_[2].memory.technique, half.technique);
  EXPECT_EQ(candidates_[2].memory.total, half.total);

  // In turn, nothing is allocated.
  ASSERT_TRUE(time_in_turn(*session_, candidates_, 1).ok());
  const uint64_t held = session_->context.memory().total_bytes;
  ASSERT_TRUE(time_in_turn(*session_, candidates_, 20).ok());
  EXPECT_EQ(session_->context.memory().total_bytes, held);
}

}  // namespace
}  // namespace lueur::cli
