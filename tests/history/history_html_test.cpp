// SPDX-License-Identifier: Apache-2.0
// The history's section of the page, from records made by hand.
#include <gtest/gtest.h>

#include "harness/history/history_reports.h"
#include "tests/reports/example_record.h"

namespace lamina {
namespace {

HistoryRecord made(const std::string& name, uint64_t fetches, double ssim = 0.9) {
  CellRow baseline = example_cell("light_map", "front", std::vector<double>(6, 10.0));
  CellRow variant = example_cell("vertex_normal", "front", std::vector<double>(6, 5.0));
  variant.fetches = fetches;
  variant.error_covered->ssim = ssim;
  HistoryRecord one{name, example_record({baseline, variant})};
  one.record.run["commit"] = "commit_" + name;
  return one;
}

size_t count(const std::string& text, const std::string& part) {
  size_t times = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++times;
  return times;
}

TEST(HistoryHtml, NamesEachStepAndDrawsWhatMoves) {
  const std::string html = html_history(make_history({made("a", 1500), made("b", 1500), made("c", 1800)}));
  EXPECT_TRUE(has(html,
                  "<strong class=\"bad\">worse</strong> vertex_normal on vulkan, view front: fetches 1500 -&gt; 1800 "
                  "(+20.0%) at commit commit_c"))
      << html;
  const size_t row = html.find("<th scope=\"row\">fetches</th>");
  ASSERT_NE(row, std::string::npos);
  const std::string chart = html.substr(row, html.find("</tr>", row) - row);
  // Three records over 240 units: dots at 40, 120 and 200, the step between the last two; 1500 below, 1800 above.
  EXPECT_TRUE(has(chart, "cx=\"40.0\" cy=\"36.0\"")) << chart;
  EXPECT_TRUE(has(chart, "cx=\"200.0\" cy=\"4.0\"")) << chart;
  EXPECT_TRUE(has(chart, "class=\"step\" d=\"M160.0 0V40\"")) << chart;
  EXPECT_TRUE(has(chart, "<title>commit_c: 1800</title>")) << chart;
  EXPECT_TRUE(has(chart, "<td>1500</td><td>1800</td><td>+20.0%</td><td>1</td>")) << chart;
  EXPECT_TRUE(has(html, "Unchanged: ")) << "what never moved has no chart";
}

TEST(HistoryHtml, SaysWhereNothingChangedAndKeepsTagsText) {
  const std::string still = html_history(make_history({made("a", 1500), made("b", 1500)}));
  EXPECT_TRUE(has(still, "No steps: nothing changed for good."));
  EXPECT_EQ(count(still, "class=\"step\" d=\"\""), count(still, "<svg"));
  const std::string evil = html_history(make_history({made("<script>", 1500), made("\"b\"", 1501)}));
  EXPECT_FALSE(has(evil, "<script>"));
  EXPECT_TRUE(has(evil, "commit_&lt;script&gt;: 1500"));
}

TEST(HistoryHtml, AnErrorThatFellIsBetter) {
  const std::string html = html_history(make_history({made("a", 1500, 0.9), made("b", 1500, 0.95)}));
  EXPECT_TRUE(has(html, "<strong>better</strong> vertex_normal on vulkan, view front: SSIM 0.9000 -&gt; 0.9500")) << html;
}

}  // namespace
}  // namespace lamina
