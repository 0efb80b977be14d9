// SPDX-License-Identifier: Apache-2.0
// The page: safe against what a record may hold, whole, and honest about times.
#include "reports/html/html.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/reports/example_record.h"

namespace lamina {
namespace {

TEST(HtmlReport, EscapesEveryStringOfTheRecord) {
  const std::string evil = "<script>alert(\"1\")</script>&'";
  std::vector<CellRow> cells = example_cells();
  for (CellRow& cell : cells) {
    cell.scene = cell.effect = cell.device = evil;
    cell.variant += evil;
    cell.view += evil;
    cell.params = {{evil, 1}};
    cell.image = cell.difference = cell.flip = evil;
    cell.passes[0].name = evil;
    cell.passes[0].by_texture[0] = {.texture = evil, .format = evil, .filter = evil, .fetches = 1};
  }
  cells.push_back(cells[3]);
  cells.back().failed = true;
  cells.back().reason = evil;
  TimerRow timer = example_timer("vulkan", false);
  timer.reason = evil;
  Record record = example_record(cells, {timer}, evil);
  for (const char* name : {"lamina", "commit", "command", "scene"}) record.run[name] = evil;
  record.run["machine"] = {{evil, evil}};
  record.run["settings"] = {{"difference_gain", evil}};
  record.run["warnings"] = {evil};
  record.run["devices"][0]["device"] = evil;
  record.plans.push_back({{{.effect = evil, .called_for = true, .reason = evil}}});

  const std::string page = page_of(record);
  EXPECT_EQ(count_of(page, "<script>"), 0u);
  EXPECT_FALSE(has(page, "alert(\""));
  EXPECT_FALSE(has(page, "</script>&"));
  EXPECT_TRUE(has(page, "&lt;script&gt;alert(&quot;1&quot;)&lt;/script&gt;&amp;&#39;"));
  // Once every escaped and own tag is read, no quote is left inside an attribute: all have an even count.
  std::string tag;
  for (size_t at = page.find("<body>"), end; (at = page.find('<', at)) != std::string::npos; at = end) {
    end = page.find('>', at);
    if (page.compare(at, 8, "<script>") == 0) break;
    tag = page.substr(at, end - at);
    EXPECT_EQ(count_of(tag, "\"") % 2, 0u) << tag;
  }
}

TEST(HtmlReport, LoadsNothingFromOutside) {
  std::vector<CellRow> cells = example_cells();
  cells[0].image = "https://example.com/a.png";
  cells[1].image = "//example.com/a.png";
  cells[2].image = "javascript:alert(1)";
  const std::string page = page_of(example_record(cells));
  size_t sources = 0;
  for (const char* attribute : {" src=\"", " href=\""})
    for (size_t at = page.find(attribute); at != std::string::npos; at = page.find(attribute, at + 1), ++sources)
      EXPECT_EQ(page.compare(page.find('"', at) + 1, 2, "./"), 0) << page.substr(at, 60);
  EXPECT_EQ(sources, 8u);
  EXPECT_FALSE(has(page, "url("));
  EXPECT_FALSE(has(page, "@import"));
  EXPECT_FALSE(has(page, "<link"));
}

TEST(HtmlReport, PictureUrlsStayRelative) {
  EXPECT_EQ(picture_url("images/a b#1?.png"), "./images/a%20b%231%3F.png");
  EXPECT_EQ(picture_url("javascript:x"), "./javascript%3Ax");
  EXPECT_EQ(picture_url("50%\".png"), "./50%25%22.png");
  EXPECT_EQ(picture_url("caf\xc3\xa9.png"), "./caf%C3%A9.png");
}

TEST(HtmlReport, BeginsWithTheFindingInWords) {
  const std::string page = page_of(example_record(example_cells()));
  const size_t headline = page.find("<strong>layered_material</strong>: worth having"),
               choices = page.find("for the error to the baseline that you can bear, take this");
  ASSERT_NE(headline, std::string::npos);
  ASSERT_NE(choices, std::string::npos);
  EXPECT_LT(headline, choices);
  EXPECT_LT(choices, page.find("frame ms"));
}

TEST(HtmlReport, ShowsEachPictureOnceWithAWordForThoseWhoCannotSeeIt) {
  const std::string page = page_of(example_record(example_cells()));
  for (const char* name : {"light_map-front", "light_map-grazing", "vertex_normal-front", "vertex_normal-front-difference",
                           "vertex_normal-front-flip", "vertex_normal-grazing-flip"})
    EXPECT_EQ(count_of(page, fmt::format("<img loading=\"lazy\" src=\"./images/{}.png\"", name)), 1u) << name;
  EXPECT_EQ(count_of(page, "<img "), 8u);
  EXPECT_EQ(count_of(page, " alt=\""), 8u);
  EXPECT_EQ(count_of(page, "alt=\"\""), 0u);
  EXPECT_TRUE(has(page, "difference, times 8"));
  EXPECT_TRUE(has(page, "class=\"magma\""));
}

TEST(HtmlReport, TablesHaveHeadersAndEveryTagCloses) {
  std::vector<CellRow> cells = example_cells();
  cells[3].failed = true;
  cells[3].reason = "lost";
  const std::string page = page_of(example_record(cells));
  EXPECT_TRUE(has(page, "<html lang=\"en\">"));
  EXPECT_GT(count_of(page, "<th scope=\"col\""), 10u);
  for (const char* tag :
       {"table", "thead", "tbody", "tr", "th", "td", "div", "section", "article", "figure", "figcaption", "button", "ul",
        "li",    "dl",    "dt",    "dd", "h1", "h2", "h3",  "h4",      "p",       "svg",    "main",       "span",   "strong"}) {
    const size_t opened = count_of(page, fmt::format("<{}>", tag)) + count_of(page, fmt::format("<{} ", tag));
    EXPECT_EQ(opened, count_of(page, fmt::format("</{}>", tag))) << tag;
  }
}

// On paper: the axis ends at the greatest sample, 8 ms, at 2000; three rounds stand from the bottom up, and a range stands for
// the interval, since three are too few for one.
TEST(HtmlReport, EveryRoundStandsInAStripThatNeedsNoScript) {
  const std::vector<CellRow> cells = {example_cell("light_map", "front", {8, 7, 8}),
                                      example_cell("vertex_normal", "front", {2, 4, 3})};
  const std::string page = page_of(example_record(cells));
  EXPECT_TRUE(has(page, "<small>every round, 0 to 8.000 ms</small>"));
  EXPECT_TRUE(has(page,
                  "<span>vertex_normal</span><svg viewBox=\"0 0 2000 100\" preserveAspectRatio=\"none\" role=\"img\" "
                  "aria-label=\"3 rounds, 2.000 to 4.000 ms\"><path class=\"interval\" d=\"M500 0H1000V100H500z\"/>"
                  "<path d=\"M750 0V100\"/><path class=\"dots\" d=\"m500 77h1m499-27h1m-251-27h1\"/></svg>"))
      << page.substr(page.find("class=\"rounds\""), 1200);
  EXPECT_EQ(count_of(page, "class=\"dots\""), 2u);
  EXPECT_FALSE(has(page_of(example_record(cells, {example_timer("vulkan", false)})), "class=\"rounds\""));
}

TEST(HtmlReport, SaysFailuresWarningsAndWhatWasRun) {
  std::vector<CellRow> cells = example_cells();
  cells[3].failed = true;
  cells[3].reason = "the device is lost";
  const std::string page = page_of(example_record(cells, {example_timer("vulkan")}, "dev"));
  EXPECT_TRUE(has(page, "Failed: the device is lost"));
  EXPECT_TRUE(has(page, "vertex_normal on vulkan, view grazing"));
  EXPECT_TRUE(has(page, "not &#39;release&#39;"));
  EXPECT_TRUE(has(page, "<dt>Commit</dt><dd>abc1234</dd>"));
  EXPECT_TRUE(has(page, "certificate on vulkan holds"));
}

TEST(HtmlReport, AFailedCertificateShowsNoTimes) {
  std::vector<CellRow> cells = example_cells();
  for (CellRow& cell : cells) {
    cell.passes[0].ms.assign(6, 7.654321);
    cell.ratio_to_baseline = Interval{.median = 0.7654321, .low = 0.7654321, .high = 0.7654321, .rounds = 6, .coverage = 0.97};
    PassRow bake = cell.passes[0];
    bake.name = "bake";
    bake.once = true;
    cell.passes.push_back(bake);
  }
  ASSERT_TRUE(has(page_of(example_record(cells)), "7.654"));
  ASSERT_TRUE(has(page_of(example_record(cells)), "0.765"));
  ASSERT_TRUE(has(page_of(example_record(cells)), "\"samples\":[7.65432,"));
  for (const std::vector<TimerRow>& timers : {std::vector<TimerRow>{}, {example_timer("vulkan", false)}}) {
    const std::string page = page_of(example_record(cells, timers));
    EXPECT_FALSE(has(page, "7.654"));
    EXPECT_FALSE(has(page, "0.765"));
    EXPECT_FALSE(has(page, "\"samples\":[7"));
    EXPECT_FALSE(has(page, "\"ms\":[7"));
    EXPECT_TRUE(has(page, "no times are shown"));
    EXPECT_TRUE(has(page, "not timed"));
  }
}

}  // namespace
}  // namespace lamina
