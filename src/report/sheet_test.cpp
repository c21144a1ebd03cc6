// SPDX-License-Identifier: MIT
#include "report/sheet.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "image/png.h"
#include "report/report_fixture.h"
#include "report/text.h"

namespace lueur::report {
namespace {
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// What stands in the page's element of this id.
std::string script_text(const std::string& page, const std::string& id) {
  const size_t begin = page.find('>', page.find("id=\"" + id + "\"")) + 1;
  return page.substr(begin, page.find("</script>", begin) - begin);
}

SheetPicture one_pixel(const std::string& camera, uint8_t grey) {
  const auto png = encode_png(Image8{1, 1, 3, {grey, grey, grey}}, "pixel");
  EXPECT_TRUE(png.ok());
  return {camera, -1.5f, png.ok() ? *png : std::vector<uint8_t>()};
}

Sheet two_scenes() {
  Sheet sheet;
  sheet.title = "Sheet </script>";
  sheet.width = sheet.height = 1;
  sheet.scenes = {{"box", "models/box.glb", 12, 3.5, {"a warning"}, {one_pixel("front", 1)}},
                  {"room", "room", 2, 1.0, {}, {one_pixel("left", 2), one_pixel("right", 3)}}};
  sheet.refused = {{"models/bad.glb", "too short \xff"}};
  return sheet;
}

class SheetTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "lueur-sheet-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path folder_;
};

TEST_F(SheetTest, EverythingIsInThePage) {
  ASSERT_TRUE(write_sheet(two_scenes(), folder_ / "sheet.html").ok());
  const std::string page = text_of(folder_ / "sheet.html");
  EXPECT_NE(page.find("<title>Sheet &lt;/script&gt;</title>"), std::string::npos);
  const Json data = Json::parse(script_text(page, "data"));
  EXPECT_EQ(data["size"], Json({1, 1}));
  EXPECT_EQ(data["scenes"][0]["source"], "models/box.glb");
  EXPECT_EQ(data["scenes"][0]["triangles"], 12);
  EXPECT_EQ(data["scenes"][0]["warnings"], Json({"a warning"}));
  EXPECT_EQ(data["scenes"][1]["pictures"][1]["camera"], "right");
  EXPECT_EQ(data["scenes"][1]["pictures"][1]["exposure_ev"], -1.5);
  EXPECT_EQ(data["refused"][0]["reason"], "too short \xef\xbf\xbd");
}

// The script counts pictures through all scenes.
TEST_F(SheetTest, PicturesAreNumberedInOrder) {
  const Sheet sheet = two_scenes();
  ASSERT_TRUE(write_sheet(sheet, folder_ / "sheet.html").ok());
  const std::string page = text_of(folder_ / "sheet.html");
  EXPECT_EQ(script_text(page, "picture-0"), base64(sheet.scenes[0].pictures[0].png));
  EXPECT_EQ(script_text(page, "picture-1"), base64(sheet.scenes[1].pictures[0].png));
  EXPECT_EQ(script_text(page, "picture-2"), base64(sheet.scenes[1].pictures[1].png));
  EXPECT_EQ(page.find("picture-3"), std::string::npos);
}

TEST_F(SheetTest, AFolderThatIsMissingIsAnError) {
  const Result<void> written = write_sheet(two_scenes(), folder_ / "missing" / "sheet.html");
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().kind, ErrorKind::output);
}

}  // namespace
}  // namespace lueur::report
