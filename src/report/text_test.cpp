// SPDX-License-Identifier: MIT
#include "report/text.h"

#include <gtest/gtest.h>

namespace lueur::report {
namespace {

using Json = nlohmann::ordered_json;

TEST(Text, BytesThatAreNotUtf8AreReplaced) {
  EXPECT_EQ(valid_utf8("plain é"), "plain é");
  EXPECT_EQ(valid_utf8("a\xff"
                       "b"),
            "a\xef\xbf\xbd"
            "b");
  EXPECT_EQ(valid_utf8("quote \" back \\ nul" + std::string(1, '\0')),
            "quote \" back \\ nul" + std::string(1, '\0'));
}

TEST(Text, HtmlHasNoMarkupLeft) {
  EXPECT_EQ(html_escaped("<b a=\"1\">&\xff"), "&lt;b a=&quot;1&quot;&gt;&amp;\xef\xbf\xbd");
}

TEST(Text, JsonForAScriptCannotEndIt) {
  const Json json = {{"a</script>", "<!-- <script> \xfe"}};
  const std::string text = json_for_script(json);
  EXPECT_EQ(text.find('<'), std::string::npos);
  const Json back = Json::parse(text);
  EXPECT_EQ(back["a</script>"], "<!-- <script> \xef\xbf\xbd");
}

TEST(Text, Base64OfRfc4648) {
  const auto encoded = [](std::string_view text) {
    return base64({reinterpret_cast<const uint8_t*>(text.data()), text.size()});
  };
  EXPECT_EQ(encoded(""), "");
  EXPECT_EQ(encoded("f"), "Zg==");
  EXPECT_EQ(encoded("fo"), "Zm8=");
  EXPECT_EQ(encoded("foo"), "Zm9v");
  EXPECT_EQ(encoded("foobar"), "Zm9vYmFy");
  EXPECT_EQ(encoded("\xff\xfe\xfd"), "//79");
}

}  // namespace
}  // namespace lueur::report
