// SPDX-License-Identifier: MIT
// What a technique remembers of moving frames must not reach the standing ones, nor the other way
// round.
#include "sequence.h"
#include "session_fixture.h"

namespace lueur::cli {
namespace {

// Keeps what an instance has noted when that is gone.
class Logging final : public Technique {
 public:
  explicit Logging(std::vector<bool>& log) : log_(log) {}
  ~Logging() override { log_ = technique_.remembered; }
  Outputs render(Frame& frame, const Inputs& inputs) override {
    return technique_.render(frame, inputs);
  }
  void* settings() override { return nullptr; }

 private:
  std::vector<bool>& log_;
  Remembering technique_;
};

// Of all instances made, in their order.
std::vector<std::unique_ptr<std::vector<bool>>>& logs() {
  static std::vector<std::unique_ptr<std::vector<bool>>> all;
  return all;
}

std::unique_ptr<Technique> make_logging() {
  logs().push_back(std::make_unique<std::vector<bool>>());
  return std::make_unique<Logging>(*logs().back());
}

std::vector<bool> remembered_but_first(size_t frames) {
  std::vector<bool> all(frames, true);
  all[0] = false;
  return all;
}

class SequenceHistoryTest : public SessionTest {};

TEST_F(SequenceHistoryTest, MovingAndStandingFramesAreApart) {
  auto loaded = load_scene("cornell");
  ASSERT_TRUE(loaded.ok());
  auto renderer = Renderer::create(*session_->system, session_->context, loaded->scene);
  ASSERT_TRUE(renderer.ok());
  const TechniqueInfo info{"logging", "", "", {}, make_logging};
  const ChosenTechnique technique{&info, make_logging(), "logging"};
  const Sequence sequence{.setup = {{16, 9}, 0}, .frames = 3, .settle = 2, .average = 4};
  std::vector<uint32_t> taken;
  const auto take = [&](uint32_t frame, std::span<const Pixels>) -> Result<void> {
    taken.push_back(frame);
    return {};
  };
  const auto errors =
      measure_sequence(*session_, **renderer, loaded->scene, 0, sequence, technique, take);
  ASSERT_TRUE(errors.ok()) << errors.error().message;
  EXPECT_EQ(taken, (std::vector<uint32_t>{0, 1, 2}));

  // The one given is not used: its instances remember the frames of earlier sequences.
  ASSERT_EQ(logs().size(), 3u);
  EXPECT_EQ(*logs()[1], remembered_but_first(2 + 3));
  const std::vector<bool> instant = remembered_but_first(2 + 4);
  std::vector<bool> standing;
  for (int frame = 0; frame < 3; ++frame)
    standing.insert(standing.end(), instant.begin(), instant.end());
  EXPECT_EQ(*logs()[2], standing);
}

}  // namespace
}  // namespace lueur::cli
