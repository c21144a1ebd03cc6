// SPDX-License-Identifier: MIT
#include "frame_names.h"

#include <gtest/gtest.h>

namespace lueur::cli {
namespace {

TEST(FrameNames, ReadsRanges) {
  const auto range = parse_frames("3-12");
  ASSERT_TRUE(range.ok());
  EXPECT_EQ(range->first, 3u);
  EXPECT_EQ(range->last, 12u);
  EXPECT_EQ(range->count(), 10u);
  const auto one = parse_frames("7");
  ASSERT_TRUE(one.ok());
  EXPECT_EQ(one->first, 7u);
  EXPECT_EQ(one->count(), 1u);
  EXPECT_TRUE(parse_frames("0-999999").ok());
  for (const char* text : {"", "-", "-1", "1-", "2-1", "0-1000000", "1-2-3", "0 - 1", "a-b", "0.5",
                           "1e3", "99999999999999999999"}) {
    const auto wrong = parse_frames(text);
    ASSERT_FALSE(wrong.ok()) << text;
    EXPECT_NE(wrong.error().message.find("'" + std::string(text) + "'"), std::string::npos);
  }
}

TEST(FrameNames, PutsNumbersIntoNames) {
  EXPECT_EQ(name_of_frame("{frame}.png", 12), "12.png");
  EXPECT_EQ(name_of_frame("a/b-{frame:4}.exr", 12), "a/b-0012.exr");
  EXPECT_EQ(name_of_frame("{frame:1}-{frame:3}.png", 1234), "1234-1234.png");
  for (const char* name : {"a.png", "{frame", "{frame:}", "{frame:0}", "{frame:x}", "{frame:12}"}) {
    EXPECT_FALSE(has_frame(name)) << name;
    EXPECT_EQ(name_of_frame(name, 3), name);
  }
  EXPECT_EQ(name_of_frame("{frame:x}{frame}", 3), "{frame:x}3");
}

TEST(FrameNames, FramesHaveDifferentNames) {
  const FrameRange ten{0, 9}, twelve{0, 11};
  const std::vector<std::string> meet_at_11 = {"{frame}.png", "1{frame}.png"};
  EXPECT_FALSE(check_frame_outputs(meet_at_11, twelve, {8, 8}).ok());
  EXPECT_FALSE(check_frame_outputs({"{frame}.png", "{frame:1}.png"}, ten, {8, 8}).ok());
  const auto outputs = check_frame_outputs({"{frame}.png", "0{frame}.png"}, twelve, {8, 8});
  ASSERT_TRUE(outputs.ok()) << outputs.error().message;
  EXPECT_EQ(outputs->pictures.size(), 2u);
}

}  // namespace
}  // namespace lueur::cli
