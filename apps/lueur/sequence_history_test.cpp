// SPDX-License-Identifier: MIT
// What a technique remembers of moving frames must not reach the standing ones, nor the other way
// round.
#include <set>

#include "sequence.h"
#include "session_fixture.h"

namespace lueur::cli {
namespace {

struct Log {
  std::vector<bool> remembered;
  std::set<std::string> histories;  // names of those that its frames had
};

// Keeps what an instance has noted when that is gone.
class Logging final : public Technique {
 public:
  explicit Logging(Log& log) : log_(log) {}
  ~Logging() override { log_.remembered = technique_.remembered; }
  Outputs render(Frame& frame, const Inputs& inputs) override {
    log_.histories.insert(frame.recorder().options.history_of);
    return technique_.render(frame, inputs);
  }
  void* settings() override { return nullptr; }

 private:
  Log& log_;
  Remembering technique_;
};

// Of all instances made, in their order.
std::vector<std::unique_ptr<Log>>& logs() {
  static std::vector<std::unique_ptr<Log>> all;
  return all;
}

std::unique_ptr<Technique> make_logging() {
  logs().push_back(std::make_unique<Log>());
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
  const TechniqueInfo info{"logging", "", "", "", {}, make_logging};
  const ChosenTechnique technique{&info, make_logging(), "logging"};
  const Sequence sequence{.setup = {{16, 9}, 0}, .frames = 3, .settle = 2, .average = 4};
  std::vector<uint32_t> taken;
  const auto take = [&](uint32_t frame, std::span<const Pixels>) -> Result<void> {
    taken.push_back(frame);
    return {};
  };
  const auto errors =
      measure_sequence(*session_, **renderer, loaded->scene, {}, sequence, technique, take);
  ASSERT_TRUE(errors.ok()) << errors.error().message;
  EXPECT_EQ(taken, (std::vector<uint32_t>{0, 1, 2}));

  // The one given is not used: its instances remember the frames of earlier sequences.
  ASSERT_EQ(logs().size(), 3u);
  const Log &moving = *logs()[1], &standing = *logs()[2];
  EXPECT_EQ(moving.remembered, remembered_but_first(2 + 3));
  std::vector<bool> instants;
  for (int frame = 0; frame < 3; ++frame)
    for (const bool valid : remembered_but_first(2 + 4)) instants.push_back(valid);
  EXPECT_EQ(standing.remembered, instants);
  EXPECT_EQ(moving.histories.size(), 1u);
  EXPECT_EQ(standing.histories.size(), 1u);
  EXPECT_NE(moving.histories, standing.histories);
}

}  // namespace
}  // namespace lueur::cli
