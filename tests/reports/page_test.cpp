// SPDX-License-Identifier: Apache-2.0
// What a gate's page says first, and the files of a report: pictures inside or beside, several records in one folder.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "harness/core/error.h"
#include "harness/core/text.h"
#include "reports/gate/gate.h"
#include "reports/gate/reading.h"
#include "reports/html/html.h"
#include "tests/folder.h"
#include "tests/reports/example_gate.h"

namespace lamina {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

TEST(Gate, TheAnswerComesFirstThenItsVerdictThenWhatMoved) {
  Record record = example_failed_gate();
  record.cells = example_record(example_cells()).cells;
  record.gates[0].against = "commit 1<2";
  const std::string page = page_of(record);
  const size_t answer = page.find("<strong>layered_material</strong>: worth having"),
               verdict =
                   page.find("<strong>Gate FAILED: 6 checks: 2 regressed, 1 ambiguous, 1 not compared, 1 better, 1 the same"),
               conditions =
                   page.find("against commit 1&lt;2; 60 rounds in 3 processes, 41.2 s; margin 2%, confidence 95% over 12"),
               choices = page.find("that you can bear, take this"),
               regressed = page.find("<details class=\"verdicts printed\" open><summary>Regressed: 2</summary>"),
               ambiguous = page.find("<summary>Ambiguous: 1</summary>"), all = page.find("<summary>All 6 checks</summary>");
  const std::vector<size_t> order = {answer, verdict, conditions, choices, regressed, ambiguous, all};
  EXPECT_NE(order.back(), std::string::npos);
  EXPECT_TRUE(std::ranges::is_sorted(order)) << testing::PrintToString(order);
  EXPECT_TRUE(has(page, "class=\"verdict unwell\""));
  EXPECT_TRUE(has(page, "<li><strong>slower</strong> (time, interval) the composite pass takes 10% longer</li>"));
  EXPECT_TRUE(has(page, "A/A vertex_normal on vulkan: 1.001 [0.997, 1.004], 60 samples: same"));
  EXPECT_FALSE(has(page_of(example_passed_gate()), "class=\"verdict unwell\""));
  EXPECT_TRUE(has(page_of(example_passed_gate()), "<strong>Gate passed: 1 check: 1 the same</strong>"));
  EXPECT_TRUE(
      has(page,
          "<summary>Not compared: 1</summary>\n<ul>\n<li><strong>not_compared</strong> (time, interval) another machine</li>"));
  EXPECT_FALSE(has(page_of(example_record(example_cells())), "Gate"));
  Record equal = example_passed_gate();
  equal.cells.clear();
  EXPECT_TRUE(has(page_of(equal), "<h1>heart: gate</h1>"));
}

TEST(Gate, PageSummaryAndCommentHoldTheSameRows) {
  const Record record = example_failed_gate();
  const std::string page = page_of(record), summary = markdown_summary(record), comment = gate_markdown(record);
  const std::string row =
      "| slower | time | interval | layered_material | vertex_normal | vulkan | pass composite | 10.00 -&gt; 11.00 ms | +10.0% "
      "\\[+8.0%, "
      "+12.0%\\] | 96.1% interval, 60 samples | 0.03 |";
  EXPECT_TRUE(has(summary, row)) << summary;
  EXPECT_TRUE(has(comment, row)) << comment;
  EXPECT_TRUE(has(page,
                  "<tr class=\"bad\"><th "
                  "scope=\"row\">slower</th><td>time</td><td>interval</td><td>layered_material</td><td>vertex_normal</td>"
                  "<td>vulkan</td><td class=\"wrap\">pass composite</td><td class=\"num\">10.00 -&gt; 11.00 ms</td>"
                  "<td class=\"num\">+10.0% [+8.0%, +12.0%]</td>"));
  EXPECT_GT(page.find("<tr><th scope=\"row\">same</th>"), page.find("<tr class=\"bad\">")) << "what regressed comes first";
  EXPECT_GT(comment.find("| same |"), comment.find("| slower |"));
  EXPECT_TRUE(has(summary, "- the composite pass takes 10% longer\n"));
  EXPECT_TRUE(has(summary, "- gate FAILED: 6 checks: 2 regressed"));
  EXPECT_TRUE(has(summary, "A/A vertex_normal on vulkan: 1.001"));
}

TEST(Gate, ARecordWhoseFiguresContradictItsAnswerIsNoPassOnThePage) {
  const std::string page = page_of(example_gate(Verdict::same, 0, {example_slower()}));
  EXPECT_TRUE(has(page, "Gate FAILED"));
  EXPECT_TRUE(has(page, "the gate says that all is well, yet figures regressed"));
  EXPECT_FALSE(has(page, "Gate passed"));
}

TEST(Gate, CountsHaveAllTheirDigits) {
  VerdictRow verdict = example_fetches();
  verdict.before = 10485760, verdict.after = 10485761, verdict.limit = 10485760;
  EXPECT_EQ(before_and_after(verdict), "10485760 -> 10485761");
  EXPECT_EQ(limit_of(verdict), "10485760");
}

TEST(Gate, WhatIsKnownOfOneSideAloneSaysOfWhich) {
  VerdictRow verdict = example_slower();
  verdict.before.reset();
  EXPECT_EQ(before_and_after(verdict), "now 11.00 ms");
  verdict.before = 10, verdict.after.reset();
  EXPECT_EQ(before_and_after(verdict), "was 10.00 ms");
  verdict.before.reset();
  EXPECT_EQ(before_and_after(verdict), "");
}

class Reports : public InFolder<> {
 protected:
  fs::path write(const std::string& name, const std::string& commit, std::vector<CellRow> cells = example_cells()) {
    const fs::path run = folder_ / name;
    fs::create_directories(run / "images");
    Record record = example_record(cells);
    record.run["commit"] = commit;
    std::ofstream lines(run / "record.jsonl");
    lines << record.run.dump() << '\n' << to_json(record.timers[0]).dump() << '\n';
    for (const CellRow& cell : record.cells) {
      lines << to_json(cell).dump() << '\n';
      for (const std::string& path : {cell.image, cell.difference, cell.flip})
        if (!path.empty() && fs::path(path).is_relative()) std::ofstream(run / path) << "png of " + commit;
    }
    return run;
  }
};

TEST_F(Reports, OneFileHoldsItsPictures) {
  const fs::path run = write("a", "abc");
  write_reports({run}, {.single_file = true, .out = {}});
  const std::string page = read_file(run / "index.html", "test");
  EXPECT_TRUE(has(page, "src=\"data:image/png;base64,cG5nIG9mIGFiYw==\""));  // "png of abc"
  EXPECT_FALSE(has(page, "src=\"./"));
  EXPECT_FALSE(fs::exists(run / "images/light_map-front.png.js"));
}

TEST_F(Reports, PicturesBesideThePageAreThereAsScriptsToo) {
  const fs::path run = write("a", "abc");
  write_reports(run);
  EXPECT_EQ(read_file(run / "images/light_map-front.png.js", "test"),
            "lamina_pixels(\"images/light_map-front.png\", \"data:image/png;base64,cG5nIG9mIGFiYw==\")\n");
}

TEST_F(Reports, TwoRecordsStandSideBySideInAFolderThatIsWhole) {
  const fs::path a = write("one", "abc"), b = write("two", "def"), out = folder_ / "both";
  write_reports({a, b}, {.single_file = false, .out = out});
  const std::string page = read_file(out / "index.html", "test");
  EXPECT_TRUE(has(page, "<h1>2 records side by side</h1>"));
  EXPECT_TRUE(has(page, "What the records differ in"));
  EXPECT_TRUE(has(page, "<th scope=\"row\">Commit</th><td class=\"wrap\">abc</td><td class=\"wrap\">def</td>"));
  EXPECT_TRUE(has(page, "src=\"./b/images/vertex_normal-front.png\""));
  EXPECT_EQ(read_file(out / "b/images/vertex_normal-front.png", "test"), "png of def");
  EXPECT_TRUE(fs::exists(out / "a/cells.csv"));
  write_reports({a, b}, {.single_file = false, .out = folder_ / "again"});
  EXPECT_EQ(page, read_file(folder_ / "again/index.html", "test"));
}

TEST_F(Reports, APictureOutsideTheRunsFolderIsRefused) {
  std::vector<CellRow> cells = example_cells();
  cells[0].image = "../../secret.png";
  const fs::path run = write("a", "abc", cells);
  for (const ReportOptions& options : {ReportOptions{}, ReportOptions{.single_file = true, .out = {}},
                                       ReportOptions{.single_file = false, .out = folder_ / "out"}}) {
    try {
      write_reports({run}, options);
      ADD_FAILURE() << "accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.subject(), "../../secret.png");
      EXPECT_TRUE(has(error.message(), "out of the run's folder"));
    }
  }
}

TEST_F(Reports, AMissingPictureIsNamedWhereItIsNeeded) {
  const fs::path run = write("a", "abc");
  fs::remove(run / "images/vertex_normal-front.png");
  EXPECT_NO_THROW(write_reports(run));
  EXPECT_THROW(write_reports({run}, {.single_file = true, .out = {}}), Error);
}

}  // namespace
}  // namespace lamina
