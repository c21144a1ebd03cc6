// SPDX-License-Identifier: MIT
#include "report/figure_page.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "report/report_fixture.h"

namespace lueur::report {
namespace {
namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

FigurePage every_block() {
  FigurePage page;
  page.title = "Figures </script>";
  page.facts = {{"device", "llvmpipe"}};
  page.sections = {
      {"Figure 1",
       {Paragraph{"text"},
        PictureRow{{{Image8{2, 1, 3, {0, 1, 2, 3, 4, 5}}, "two pixels", {{0.0, 0.5, 2.0, 0.5}}}},
                   "a row"},
        Table{"times",
              {{"level", "", ""}, {"time", "ms", "paper"}, {"time", "ms", "ours", 2}},
              {{"0", 1.5, std::monostate{}}}},
        Plot{"slice",
             {"x in px", false},
             {"radiance", true},
             {{"ours", {{0, 1}, {1, NAN}}, true}}}}}};
  return page;
}

class FigurePageTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "lueur-figures-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path folder_;
};

TEST_F(FigurePageTest, NumbersAreInJson) {
  ASSERT_TRUE(write_figure_page(every_block(), folder_).ok());
  const Json json = Json::parse(text_of(folder_ / "figures.json"));
  EXPECT_EQ(json["title"], "Figures </script>");
  const Json& blocks = json["sections"][0]["blocks"];
  ASSERT_EQ(blocks.size(), 4u);
  EXPECT_EQ(blocks[0]["text"], "text");
  EXPECT_EQ(blocks[1]["pictures"][0]["size"], Json({2, 1}));
  EXPECT_FALSE(blocks[1]["pictures"][0].contains("url"));
  EXPECT_EQ(blocks[2]["rows"][0], Json({"0", 1.5, nullptr}));
  EXPECT_EQ(blocks[2]["columns"][1]["group"], "paper");
  EXPECT_EQ(blocks[2]["columns"][2]["digits"], 2);
  EXPECT_EQ(blocks[3]["curves"][0]["points"][0], Json({0.0, 1.0}));
  EXPECT_TRUE(blocks[3]["curves"][0]["points"][1][1].is_null());
  EXPECT_EQ(blocks[3]["y"]["log"], true);
}

TEST_F(FigurePageTest, PicturesAreInThePage) {
  ASSERT_TRUE(write_figure_page(every_block(), folder_).ok());
  const std::string page = text_of(folder_ / "index.html");
  // The signature of a PNG in base64.
  EXPECT_NE(page.find("data:image/png;base64,iVBORw0KGgo"), std::string::npos);
  EXPECT_NE(page.find("<title>Figures &lt;/script&gt;</title>"), std::string::npos);
  ASSERT_TRUE(write_figure_page(every_block(), folder_).ok());
  EXPECT_EQ(text_of(folder_ / "index.html"), page);
}

TEST_F(FigurePageTest, AnEmptyPictureIsAnErrorAndWritesNothing) {
  FigurePage page = every_block();
  std::get<PictureRow>(page.sections[0].blocks[1]).pictures[0].image = Image8{0, 0, 3, {}};
  const Result<void> written = write_figure_page(page, folder_ / "new");
  ASSERT_FALSE(written.ok());
  EXPECT_NE(written.error().message.find("two pixels"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder_ / "new"));
}

}  // namespace
}  // namespace lueur::report
