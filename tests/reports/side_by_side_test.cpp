// SPDX-License-Identifier: Apache-2.0
// Two records on one page: what they differ in, and each figure under its own record.
#include <gtest/gtest.h>

#include "reports/html/html.h"
#include "tests/reports/example_record.h"

namespace lamina {
namespace {

std::string row(const std::string& head, const std::string& a, const std::string& b) {
  return "<tr><th scope=\"row\">" + head + "</th><td class=\"wrap\">" + a + "</td><td class=\"wrap\">" + b + "</td></tr>";
}

// The second is of another commit; vertex_normal failed in it, and it has a variant more.
std::vector<Record> two_records() {
  std::vector<CellRow> cells = example_cells();
  for (CellRow& cell : cells) cell.failed = cell.variant == "vertex_normal", cell.reason = cell.failed ? "no such file" : "";
  cells.push_back(example_cell("another", "front", {2, 2, 2, 2, 2, 2}));
  std::vector<Record> records = {example_record(example_cells()), example_record(cells)};
  records[0].run.erase("scene");
  records[1].run["commit"] = "def5678";
  return records;
}

TEST(SideBySide, FactsThatDifferStandUnderTheirRecordAndOthersNowhere) {
  const std::string html = html_side_by_side(two_records());
  EXPECT_TRUE(has(html, "<th scope=\"col\">A: abc1234</th><th scope=\"col\">B: def5678</th>"));
  EXPECT_TRUE(has(html, row("Commit", "abc1234", "def5678")));
  EXPECT_TRUE(has(html, row("Scene", "", "heart")));
  for (const char* same : {"Command", "Build", "Machine", "Lamina"})
    EXPECT_FALSE(has(html, std::string("<th scope=\"row\">") + same)) << same;
}

TEST(SideBySide, FiguresStandUnderTheirRecord) {
  const std::string html = html_side_by_side(two_records());
  EXPECT_TRUE(has(html, row("vertex_normal on vulkan (layered_material)",
                            "5.000 [5.000, 5.000] ms, 15.0 fetches/px, SSIM 0.9000, FLIP 0.1000", "failed")))
      << html;
  EXPECT_TRUE(has(html, row("another on vulkan (layered_material)", "-",
                            "2.000 [2.000, 2.000] ms, 15.0 fetches/px, SSIM 0.9000, FLIP 0.1000")))
      << html;
  std::vector<Record> untimed = two_records();
  untimed[0].timers.clear();
  EXPECT_TRUE(has(html_side_by_side(untimed), "<td class=\"wrap\">not timed, 15.0 fetches/px, SSIM 0.9000, FLIP 0.1000</td>"));
}

TEST(SideBySide, RecordsOfTheSameRunSayTheSame) {
  const Record record = example_record(example_cells());
  EXPECT_TRUE(has(html_side_by_side({record, record}), "The records say the same of where and how they were run."));
}

TEST(SideBySide, EachRecordFollowsWholeUnderItsName) {
  const std::string page = html_report(two_records());
  const size_t a = page.find("<h2>A: abc1234</h2>"), b = page.find("<h2>B: def5678</h2>");
  ASSERT_NE(b, std::string::npos);
  EXPECT_LT(a, b);
  EXPECT_GT(page.find("<dt>Commit</dt><dd>def5678</dd>"), b);
  EXPECT_GT(page.find("no such file", b), b);
  EXPECT_NE(page.find("no such file", b), std::string::npos);
  EXPECT_LT(page.find("<dt>Commit</dt><dd>abc1234</dd>"), b);
}

}  // namespace
}  // namespace lamina
