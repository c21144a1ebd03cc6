// SPDX-License-Identifier: MIT
#include "report/comparison.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>

#include "report/page_sources.h"
#include "report/report_fixture.h"

namespace lueur::report {
namespace {
namespace fs = std::filesystem;

size_t count_of(std::string_view text, std::string_view part) {
  size_t count = 0;
  for (size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

ImageF filled(uint32_t width, uint32_t height, uint32_t channels, float value) {
  ImageF image(width, height, channels);
  for (float& sample : image.samples) sample = value;
  return image;
}

Comparison small(uint32_t width, uint32_t height) {
  Comparison comparison;
  comparison.title = "small";
  comparison.width = width;
  comparison.height = height;
  comparison.direct = filled(width, height, 3, 0.1f);
  comparison.references = {{"path",
                            "path",
                            4,
                            0.1,
                            1.0,
                            {filled(width, height, 3, 0.5f), filled(width, height, 3, 0.25f)}}};
  Entry entry;
  entry.label = entry.technique = "hierarchical";
  entry.pictures = {filled(width, height, 3, 0.4f), filled(width, height, 3, 0.2f)};
  entry.errors = {{"path", {{"rmse", 0.1}}, {{"flip", filled(width, height, 1, 0.3f), 1.0}}}};
  comparison.entries = {entry};
  return comparison;
}

class ComparisonTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "lueur-report-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string page_of(const Comparison& comparison) const {
    const Result<void> written = write_comparison(comparison, folder_ / "made" / "here");
    EXPECT_TRUE(written.ok()) << written.error().message;
    return text_of(folder_ / "made" / "here" / "index.html");
  }

  fs::path folder_;
};

TEST_F(ComparisonTest, WritesThreeFiles) {
  const std::string page = page_of(small(16, 9));
  EXPECT_EQ(page.rfind("<!DOCTYPE html>", 0), 0u);
  EXPECT_EQ(count_of(page, "<script type=\"text/plain\" id=\"picture-"), 6u);
  EXPECT_EQ(Json::parse(text_of(folder_ / "made/here/results.json"))["entries"].size(), 1u);
  EXPECT_EQ(count_of(text_of(folder_ / "made/here/results.csv"), "\n"), 2u);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "made/here"), {}), 3);
}

TEST_F(ComparisonTest, AskForNothingOutside) {
  const std::string page = page_of(small(16, 9));
  // The one address is a name: of SVG's elements.
  EXPECT_EQ(count_of(page, "://"), count_of(page, "http://www.w3.org/2000/svg"));
  EXPECT_EQ(count_of(page, "src="), 0u);
  EXPECT_EQ(count_of(page, "Content-Security-Policy"), 1u);
}

TEST_F(ComparisonTest, SameInputSameBytes) {
  const std::string once = page_of(small(33, 17));
  EXPECT_EQ(page_of(small(33, 17)), once);
}

TEST_F(ComparisonTest, OnePixelIsAPicture) {
  EXPECT_EQ(count_of(page_of(small(1, 1)), "id=\"picture-"), 6u);
}

TEST_F(ComparisonTest, NothingAtAllIsAPageToo) {
  Comparison comparison;
  comparison.title = "empty";
  EXPECT_EQ(count_of(page_of(comparison), "id=\"picture-"), 0u);
}

TEST_F(ComparisonTest, TextCannotBecomeMarkup) {
  Comparison comparison = small(2, 2);
  const std::string evil = "</script><script>alert(1)</script><!--\xff\"'";
  comparison.title = comparison.scene = comparison.command = evil;
  comparison.entries[0].label = evil;
  comparison.entries[0].settings[evil] = evil;
  comparison.references[0].label = evil;
  comparison.entries[0].errors[0].reference = evil;
  const std::string harmless = page_of(small(2, 2));
  const std::string page = page_of(comparison);
  EXPECT_EQ(count_of(page, "<script"), count_of(harmless, "<script"));
  EXPECT_EQ(count_of(page, "</script"), count_of(harmless, "</script"));
  EXPECT_EQ(count_of(page, "<!--"), count_of(harmless, "<!--"));
}

TEST_F(ComparisonTest, PicturesWithNanGetAWarning) {
  Comparison comparison = small(2, 2);
  comparison.entries[0].pictures.composed.samples[4] = std::nanf("");
  const std::string page = page_of(comparison);
  EXPECT_EQ(count_of(page, "hierarchical: 1 samples are negative or not finite"), 1u);
}

TEST_F(ComparisonTest, AFolderThatCannotBeIsAnError) {
  std::ofstream(folder_ / "file") << "no folder";
  const Result<void> written = write_comparison(small(2, 2), folder_ / "file" / "below");
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().kind, ErrorKind::output);
  EXPECT_NE(written.error().message.find("file/below"), std::string::npos);
}

TEST(ComparisonDeathTest, PicturesOfAnotherSizeAreOurOwnFault) {
  Comparison comparison = small(2, 2);
  comparison.entries[0].pictures.composed = filled(3, 2, 3, 0.0f);
  EXPECT_DEATH((void)write_comparison(comparison, "never"), "width");
  comparison = small(2, 2);
  comparison.entries[0].errors[0].values = {{"rsme", 1.0}};
  EXPECT_DEATH((void)write_comparison(comparison, "never"), "metrics");
}

// What is embedded stands within <script> and <style>: it must not be able to end them.
TEST(PageSources, HoldNoEndTagOfTheirElement) {
  for (const std::string_view script : kComparisonScripts) {
    EXPECT_EQ(count_of(script, "</script"), 0u);
    EXPECT_EQ(count_of(script, "<!--"), 0u);
    EXPECT_EQ(count_of(script, "innerHTML"), 0u);
  }
  for (const std::string_view style : {kBaseStyle, kComparisonStyle})
    EXPECT_EQ(count_of(style, "</style"), 0u);
}

}  // namespace
}  // namespace lueur::report
