// SPDX-License-Identifier: Apache-2.0
// What the terminal, Markdown and CSV say, and what they must not say.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <sstream>

#include "harness/core/error.h"
#include "harness/core/text.h"
#include "reports/words.h"
#include "tests/folder.h"
#include "tests/reports/example_record.h"

namespace lamina {
namespace {

// The fields of a CSV text, by RFC 4180's grammar: a second reading of the format, apart from the code that writes it.
std::vector<std::vector<std::string>> parse_csv(const std::string& csv) {
  std::vector<std::vector<std::string>> lines = {{""}};
  bool quoted = false;
  for (size_t i = 0; i < csv.size(); ++i) {
    std::string& field = lines.back().back();
    if (quoted) {
      if (csv[i] == '"' && i + 1 < csv.size() && csv[i + 1] == '"')
        field += csv[++i];
      else if (csv[i] == '"')
        quoted = false;
      else
        field += csv[i];
    } else if (csv[i] == '"') {
      quoted = true;
    } else if (csv[i] == ',') {
      lines.back().emplace_back();
    } else if (csv[i] == '\r' && i + 1 < csv.size() && csv[i + 1] == '\n') {
      ++i;
      lines.push_back({""});
    } else {
      field += csv[i];
    }
  }
  if (lines.back() == std::vector<std::string>{""}) lines.pop_back();
  return lines;
}

// The field of a cell (0 is the first) in the named column.
std::string field(const std::vector<std::vector<std::string>>& csv, size_t cell, const std::string& column) {
  const auto at = std::find(csv.at(0).begin(), csv.at(0).end(), column);
  if (at == csv.at(0).end()) return "no column " + column;
  return csv.at(cell + 1).at(static_cast<size_t>(at - csv[0].begin()));
}

TEST(TerminalTable, ShowsEachFigureOfEachVariant) {
  const std::string table = terminal_table(example_record(example_cells()), false);
  for (const char* part :
       {"heart, 64x32, 2 views", "layered_material", "light_map", "vertex_normal", "vulkan", "10.00 [10.00, 10.00]",
        "5.000 [5.000, 5.000]", "0.500 [0.500, 0.500]", "15.0", "30.0 (30.0)", "0.9000 (0.9000)", "0.1000 (0.1000)", "frame ms",
        "fetches/px", "PSNR dB", "the timer's certificate on vulkan holds"})
    EXPECT_TRUE(has(table, part)) << part << "\n" << table;
  EXPECT_FALSE(has(table, "warning")) << table;
  EXPECT_FALSE(has(table, "\x1b")) << table;
}

TEST(TerminalTable, ColumnsAlign) {
  std::vector<CellRow> cells = example_cells();
  cells[2].variant = cells[3].variant = "caf\xc3\xa9";  // four columns, five bytes
  std::istringstream table(terminal_table(example_record(cells), false));
  std::vector<size_t> ends;  // of the backend's name, in columns
  for (std::string line; std::getline(table, line);)
    if (const size_t at = line.find("vulkan  "); at != std::string::npos) ends.push_back(at - (has(line, "caf") ? 1 : 0));
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_EQ(ends[0], ends[1]);
}

TEST(TerminalTable, ColourAddsOnlyEmphasis) {
  const Record record = example_record(example_cells(), {example_timer("vulkan")}, "dev");
  std::string coloured = terminal_table(record, true);
  EXPECT_TRUE(has(coloured, "\x1b[1m"));
  for (size_t at; (at = coloured.find('\x1b')) != std::string::npos;) coloured.erase(at, coloured.find('m', at) - at + 1);
  EXPECT_EQ(coloured, terminal_table(record, false));
}

TEST(TerminalTable, AFailedVariantKeepsItsReasonOnOneLine) {
  std::vector<CellRow> cells = example_cells();
  cells[3].failed = true;
  cells[3].reason = "vulkan: composite:\nthe device \x1b[2Jis lost";
  const std::string table = terminal_table(example_record(cells), false);
  EXPECT_TRUE(has(table, "failed in 1 of 2 views: vulkan: composite: the device  [2Jis lost")) << table;
}

TEST(TerminalTable, FewRoundsAreMarked) {
  const std::string table = terminal_table(example_record({example_cell("light_map", "front", {2, 3})}), false);
  EXPECT_TRUE(has(table, "2.500 [2.000, 3.000]*")) << table;
  EXPECT_TRUE(has(table, "* fewer than 6 rounds")) << table;
  EXPECT_FALSE(has(terminal_table(example_record(example_cells()), false), "fewer than"));
}

TEST(TextReports, ABuildThatIsNotReleaseIsSaidSo) {
  for (const char* build : {"dev", ""}) {
    const Record record = example_record(example_cells(), {example_timer("vulkan")}, build);
    EXPECT_TRUE(has(terminal_table(record, false), "not 'release'"));
    EXPECT_TRUE(has(markdown_summary(record), "not 'release'"));
  }
  EXPECT_EQ(field(parse_csv(cells_csv(example_record(example_cells(), {}, "dev"))), 0, "build"), "dev");
  EXPECT_FALSE(has(markdown_summary(example_record(example_cells())), "not 'release'"));
}

TEST(TextReports, AFailedCertificatePrintsNoTimes) {
  std::vector<CellRow> cells = example_cells();
  for (CellRow& cell : cells) {
    cell.passes[0].ms.assign(6, 7.654321);
    cell.ratio_to_baseline = Interval{.median = 0.7654321, .low = 0.7654321, .high = 0.7654321, .rounds = 6, .coverage = 0.97};
  }
  const Record good = example_record(cells), bad = example_record(cells, {example_timer("vulkan", false)}),
               none = example_record(cells, {});
  ASSERT_TRUE(has(terminal_table(good, false), "7.654"));
  ASSERT_TRUE(has(markdown_summary(good), "7.654"));
  ASSERT_TRUE(has(cells_csv(good), "7.654"));
  for (const Record* record : {&bad, &none}) {
    for (const std::string& report : {terminal_table(*record, false), markdown_summary(*record), cells_csv(*record)}) {
      EXPECT_FALSE(has(report, "7.65")) << report;
      EXPECT_FALSE(has(report, "0.765")) << report;
    }
    EXPECT_TRUE(has(terminal_table(*record, false), "no times are shown"));
    EXPECT_TRUE(has(markdown_summary(*record), "no times are shown"));
    EXPECT_TRUE(has(terminal_table(*record, false), "not timed"));
  }
  EXPECT_TRUE(has(terminal_table(bad, false), "8x work took 1.4 of linear"));
}

TEST(Headlines, SayWhatFailedOnWhichBackend) {
  std::vector<CellRow> cells = example_cells();
  EXPECT_TRUE(failure_headlines(summarize(example_record(cells))).empty());
  cells.push_back(example_cell("light_map", "front", {1, 1, 1, 1, 1, 1}, "osmesa"));
  cells.push_back(example_cell("vertex_normal", "front", {}, "osmesa"));
  cells.back().failed = true;
  cells.back().reason = "out of memory";
  cells[3].failed = true, cells[3].reason = "not a picture: all black";
  const auto all = failure_headlines(summarize(example_record(cells, {example_timer("vulkan"), example_timer("osmesa")})));
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].variant, "vertex_normal");
  EXPECT_EQ(all[0].words, "is not a picture in 1 of 2 views on vulkan: all black; it failed on osmesa: out of memory.");
}

// The rows of the first table, each with its cells.
std::vector<std::vector<std::string>> choices_in(const std::vector<CellRow>& cells, const std::vector<TimerRow>& timers) {
  const std::vector<Table> tables = choices_tables(summarize(example_record(cells, timers)));
  std::vector<std::vector<std::string>> rows;
  if (tables.empty()) return rows;
  for (const Row& row : tables.front().rows) {
    rows.push_back({row.group});
    for (const Cell& cell : row.cells) rows.back().push_back(cell.text);
  }
  return rows;
}

TEST(Choices, GoFromTheClosestToTheCheapest) {
  const std::vector<double> ten(6, 10.0), four(6, 4.0), eleven(6, 11.0);
  std::vector<CellRow> cells = {example_cell("light_map", "front", ten), example_cell("vertex_normal", "front", four),
                                example_cell("normal_map_taps", "front", eleven)};
  cells[2].error_covered->ssim = 0.99;  // closer than vertex_normal, and dearer than the baseline
  const auto rows = choices_in(cells, {example_timer("vulkan")});
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0], (std::vector<std::string>{"vulkan", "1.0000", "light_map", "1", "inf", "0.0000", "-"}));
  EXPECT_EQ(rows[1][1], "0.9000");
  EXPECT_EQ(rows[1][2], "vertex_normal");
  EXPECT_EQ(rows[1][3], "0.400 [0.400, 0.400]");
}

TEST(Choices, NameWhatMoreRoundsWouldTell) {
  const std::vector<double> ten(6, 10.0), four(6, 4.0);
  std::vector<CellRow> cells = {example_cell("light_map", "front", ten), example_cell("vertex_normal", "front", four),
                                example_cell("normal_map_taps", "front", {9, 9, 9, 11, 11, 11})};
  cells[2].error_covered->ssim = 0.95;
  EXPECT_EQ(choices_in(cells, {example_timer("vulkan")}).at(0).back(), "normal_map_taps");
}

TEST(Choices, AreByFetchesWhereNothingIsTimedAndNoneWhereOneVariantIsLeft) {
  std::vector<CellRow> cells = example_cells();
  EXPECT_TRUE(choices_in(cells, {}).empty()) << "both make the same number of fetches";
  for (CellRow* cell : {&cells[2], &cells[3]}) *cell->fetches /= 2;
  ASSERT_EQ(choices_in(cells, {}).size(), 2u);
  EXPECT_EQ(choices_in(cells, {}).at(1).at(3), "0.500");
  cells[2].failed = true;
  EXPECT_TRUE(choices_in(cells, {}).empty());
}

TEST(MarkdownSummary, HoldsWhatWasRunThePlanAndThePasses) {
  Record record = example_record(example_cells());
  PlanRow::Variant variant{.variant = "light_map", .passes = {{.pass = "blur", .runs = false, .reason = "unread"}}};
  record.plans.push_back({{{.effect = "layered_material",
                            .called_for = true,
                            .reason = "object 'heart' has layers",
                            .features = {{"SCATTER", false, "the thickness is 0"}},
                            .variants = {variant}},
                           {.effect = "volume_fog", .reason = "the scene has no fog"}}});
  record.phases.push_back({"vulkan", "layered_material", 9, 2200, 2000});
  const std::string markdown = markdown_summary(record);
  for (const char* part :
       {"| vertex_normal | vulkan | 5.000 \\[5.000, 5.000\\] | 0.500 \\[0.500, 0.500\\] | 15.0 | 30.0 (30.0) |",
        "| light_map | vulkan | composite | each frame | 10.00 | 120 | 15.0 | 6666.67 | light_map_texture (rgba16_float, "
        "linear) "
        "13.0/px, ",
        "- layered_material: called for: object 'heart' has layers", "- volume_fog: not called for: the scene has no fog",
        "- layered_material: without SCATTER: the thickness is 0",
        "- layered_material: light_map without its pass blur: unread",
        "9 rounds of layered_material on vulkan took 2.2 s, 1.10 times the device time", "Command: lamina compare heart",
        "Commit: abc1234", "Example CPU", "lp_num_threads 2", "Mesa 22.3.6", "1.3.230", "seed 1", "Build: release",
        "| vulkan | 0.9000 | vertex_normal | 0.500 \\[0.500, 0.500\\] | 30.0 | 0.1000 | - |"})
    EXPECT_TRUE(has(markdown, part)) << part << "\n" << markdown;
}

TEST(MarkdownSummary, NamesAndReasonsCannotBreakTheTables) {
  std::vector<CellRow> cells = example_cells();
  cells[2].variant = cells[3].variant = "a|b <script>";
  cells[3].failed = true;
  cells[3].reason = "line one\nline | two";
  const std::string markdown = markdown_summary(example_record(cells));
  EXPECT_TRUE(has(markdown, "a\\|b &lt;script&gt;")) << markdown;
  EXPECT_FALSE(has(markdown, "<script>"));
  EXPECT_TRUE(has(markdown, "line one line \\| two"));
}

TEST(MarkdownSummary, ARecordCutShortIsSaidSo) {
  Record record = example_record(example_cells());
  record.run["truncated"] = "line 9 is cut short";
  record.run["warnings"] = {"normals were missing"};
  EXPECT_TRUE(has(markdown_summary(record), "the record is incomplete: line 9 is cut short"));
  EXPECT_TRUE(has(terminal_table(record, false), "warning: normals were missing"));
}

TEST(CellsCsv, OneLineACellUnderNamesFromTheRecord) {
  std::vector<CellRow> cells = example_cells();
  cells[2].error_covered->psnr_db = std::numeric_limits<double>::infinity();
  cells[2].ratio_to_baseline = Interval{.median = 0.5, .low = 0.25, .high = 0.75, .rounds = 6, .coverage = 0.96875};
  const std::string text = cells_csv(example_record(cells));
  const auto csv = parse_csv(text);
  ASSERT_EQ(csv.size(), 5u);
  for (const auto& line : csv) EXPECT_EQ(line.size(), csv[0].size());
  EXPECT_TRUE(text.ends_with("\r\n"));
  EXPECT_EQ(field(csv, 2, "variant"), "vertex_normal");
  EXPECT_EQ(field(csv, 2, "baseline"), "false");
  EXPECT_EQ(field(csv, 2, "view"), "front");
  EXPECT_EQ(field(csv, 2, "median_ms"), "4.0");
  EXPECT_EQ(field(csv, 2, "ratio_to_baseline.low"), "0.25");
  EXPECT_EQ(field(csv, 2, "error.baseline.psnr_db"), "inf");
  EXPECT_EQ(field(csv, 2, "error.frame.psnr_db"), "30.0");
  EXPECT_EQ(field(csv, 2, "covered_pixels"), "100");
  EXPECT_EQ(field(csv, 2, "params.scene.time"), "0.5");
  EXPECT_EQ(field(csv, 0, "error.baseline.psnr_db"), "");  // the baseline against itself is not measured
  EXPECT_EQ(field(csv, 0, "ratio_to_baseline.low"), "");
}

TEST(CellsCsv, OperationsOfTheFrameByClass) {
  std::vector<CellRow> cells = example_cells();
  PassRow once = cells[0].passes[0], second = once;
  once.once = true, once.operations = {{"sin", 9}};
  second.operations = {{"add", 30}, {"root", 2}};
  cells[0].passes[0].operations = {{"add", 400}};
  cells[0].passes.insert(cells[0].passes.end(), {once, second});
  cells[1].passes[0].operations = {{"root", 1}};
  const auto csv = parse_csv(cells_csv(example_record(cells)));
  EXPECT_EQ(field(csv, 0, "operations.add"), "430");
  EXPECT_EQ(field(csv, 0, "operations.root"), "2");
  EXPECT_EQ(field(csv, 1, "operations.add"), "0") << "counted, and none";
  EXPECT_EQ(field(csv, 2, "operations.add"), "") << "not counted";
  EXPECT_EQ(std::ranges::count(csv[0], "operations.sin"), 0) << "done once";
}

TEST(CellsCsv, FetchesOfTheFrameByKindAndLevel) {
  std::vector<CellRow> cells = example_cells();
  std::vector<TextureFetches>& textures = cells[0].passes[0].by_texture;
  textures[0].unfiltered = 300, textures[0].dimensions = 2, textures[0].levels = {1300};
  textures[1].unfiltered = 0, textures[1].dimensions = 3, textures[1].levels = {0, 0, 200};
  PassRow once = cells[0].passes[0];
  once.once = true;
  cells[0].passes.push_back(once);
  cells[1].passes[0].by_texture = {once.by_texture[0]};
  cells[1].passes[0].by_texture[0].levels.clear();
  const auto csv = parse_csv(cells_csv(example_record(cells)));
  EXPECT_EQ(field(csv, 0, "fetches.unfiltered"), "300") << "without what is done once";
  EXPECT_EQ(field(csv, 0, "fetches.3d"), "200");
  EXPECT_NEAR(std::stod(field(csv, 0, "fetches.mean_level")), 400.0 / 1500, 1e-6);
  EXPECT_EQ(field(csv, 1, "fetches.3d"), "0");
  EXPECT_EQ(field(csv, 1, "fetches.mean_level"), "") << "not counted";
  EXPECT_EQ(field(csv, 2, "fetches.unfiltered"), "") << "of a record of before";
}

TEST(CellsCsv, QuotesCommasQuotesAndNewlines) {
  std::vector<CellRow> cells = example_cells();
  cells[0].failed = true;
  cells[0].reason = "a \"b\", c\r\nd\ne";
  cells[1].view = "side, left";
  cells[1].params["odd,name"] = 3;
  const std::string text = cells_csv(example_record(cells));
  EXPECT_TRUE(has(text, "\"a \"\"b\"\", c\r\nd\ne\"")) << text;
  const auto csv = parse_csv(text);
  EXPECT_EQ(field(csv, 0, "reason"), cells[0].reason);
  EXPECT_EQ(field(csv, 0, "median_ms"), "");
  EXPECT_EQ(field(csv, 1, "view"), "side, left");
  EXPECT_EQ(field(csv, 1, "params.odd,name"), "3.0");
  EXPECT_EQ(field(csv, 2, "params.odd,name"), "");
}

TEST(AllReports, AreTheSameBytesTwiceAndSurviveAnEmptyRecord) {
  const Record full = example_record(example_cells());
  EXPECT_EQ(terminal_table(full, true), terminal_table(full, true));
  EXPECT_EQ(markdown_summary(full), markdown_summary(full));
  EXPECT_EQ(cells_csv(full), cells_csv(full));
  EXPECT_EQ(page_of(full), page_of(full));
  Record bare;
  bare.run = {{"kind", "run"}, {"schema", 1}};
  for (const std::string& report : {terminal_table(bare, false), markdown_summary(bare), page_of(bare)})
    EXPECT_TRUE(has(report, "no cells")) << report;
}

TEST(WriteReports, LeavesThreeFilesBesideTheRecord) {
  const Folder own;
  const std::filesystem::path& folder = own.path();
  EXPECT_THROW(write_reports(folder), Error);
  const Record record = example_record(example_cells());
  {
    RecordWriter writer(folder / "record.jsonl");
    writer.append(record.run);
    for (const TimerRow& timer : record.timers) writer.append(to_json(timer));
    for (const CellRow& cell : record.cells) writer.append(to_json(cell));
  }
  write_reports(folder);
  EXPECT_EQ(read_file(folder / "summary.md", "test"), markdown_summary(record));
  EXPECT_EQ(read_file(folder / "cells.csv", "test"), cells_csv(record));
  EXPECT_EQ(read_file(folder / "index.html", "test"), html_report({record}));
}

}  // namespace
}  // namespace lamina
