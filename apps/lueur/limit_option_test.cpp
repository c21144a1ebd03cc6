// SPDX-License-Identifier: MIT
#include "limit_option.h"

#include <gtest/gtest.h>

namespace lueur::cli {
namespace {

TEST(LimitOption, SetsTheLimitThatItNames) {
  LoadLimits limits;
  ASSERT_TRUE(set_limit(limits, "vertices=12").ok());
  ASSERT_TRUE(set_limit(limits, "json-depth=7").ok());
  EXPECT_EQ(limits.vertices, 12u);
  EXPECT_EQ(limits.json_depth, 7u);
  EXPECT_EQ(limits.indices, LoadLimits().indices);
}

TEST(LimitOption, WrongOnesAreRefusedByName) {
  LoadLimits limits;
  for (const char* bad : {"vertices", "vertices=", "vertices=-1", "vertices=1e6",
                          "vertices=99999999999999999999", "json-depth=1001", "weight=3"}) {
    const auto result = set_limit(limits, bad);
    ASSERT_FALSE(result.ok()) << bad;
    EXPECT_EQ(result.error().kind, ErrorKind::usage);
  }
  const auto unknown = set_limit(limits, "weight=3");
  EXPECT_NE(unknown.error().message.find("texture-side"), std::string::npos);
  EXPECT_EQ(limits.vertices, LoadLimits().vertices);
}

}  // namespace
}  // namespace lueur::cli
