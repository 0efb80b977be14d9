// SPDX-License-Identifier: Apache-2.0
// Trends from records made by hand: their order, what is kept apart, what is left out, what is said.
#include "harness/history/trend.h"

#include <gtest/gtest.h>

#include <limits>

#include "harness/core/error.h"
#include "harness/history/history_reports.h"
#include "tests/reports/example_record.h"

namespace lamina {
namespace {

// A baseline of 10 ms and a variant of `ms`, whose fetches and SSIM are given.
HistoryRecord record_named(const std::string& name, double ms = 5, uint64_t fetches = 1500, double ssim = 0.9,
                           const std::string& commit_date = "") {
  CellRow baseline = example_cell("light_map", "front", std::vector<double>(6, 10.0));
  CellRow variant = example_cell("vertex_normal", "front", std::vector<double>(6, ms));
  variant.ratio_to_baseline = Interval{.median = ms / 10, .low = ms / 10, .high = ms / 10, .rounds = 6, .coverage = 0.96};
  variant.fetches = fetches;
  variant.error_covered->ssim = ssim;
  HistoryRecord one{name, example_record({baseline, variant})};
  one.record.run["commit"] = "commit_" + name;
  if (!commit_date.empty()) one.record.run["commit_date"] = commit_date;
  return one;
}

const Trend* trend_of(const History& history, const std::string& variant, const std::string& figure,
                      const std::string& machine_part = "") {
  for (const Trend& trend : history.trends)
    if (trend.cell.variant == variant && trend.figure->name == figure && has(trend.machine, machine_part)) return &trend;
  return nullptr;
}
std::string notes_of(const History& history) {
  std::string all;
  for (const std::string& note : history.notes) all += note + "\n";
  return all;
}
std::string names_of(const History& history) {
  std::string all;
  for (const HistoryRecord& record : history.records) all += record.name + " ";
  return all;
}
std::string refusal(std::vector<HistoryRecord> records) {
  try {
    make_history(std::move(records));
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    return error.what();
  }
  return "accepted";
}

TEST(History, HoldsEachFigureOfEachCell) {
  const History history = make_history({record_named("a", 5), record_named("b", 6)});
  const Trend* frame = trend_of(history, "vertex_normal", "frame");
  ASSERT_TRUE(frame);
  ASSERT_EQ(frame->points.size(), 2u);
  EXPECT_EQ(frame->points[0].value, 5);
  EXPECT_EQ(frame->points[1].value, 6);
  EXPECT_EQ(trend_of(history, "vertex_normal", "ratio to baseline")->points[1].value, 0.6);
  EXPECT_EQ(trend_of(history, "vertex_normal", "fetches")->points[0].value, 1500);
  EXPECT_EQ(trend_of(history, "vertex_normal", "PSNR")->points[0].value, 30);
  EXPECT_EQ(trend_of(history, "vertex_normal", "FLIP")->points[0].value, 0.1);
  EXPECT_FALSE(trend_of(history, "light_map", "ratio to baseline"));
  EXPECT_FALSE(trend_of(history, "light_map", "SSIM"));
  EXPECT_FALSE(trend_of(history, "vertex_normal", "PSNR to truth"));
}

TEST(History, IsInTheOrderOfCommitsThenOfRunsThenAsGiven) {
  const auto dated = [](const char* name, const char* date, const char* commit_date) {
    HistoryRecord one = record_named(name, 5, 1500, 0.9, commit_date);
    if (*date) one.record.run["date"] = date;
    return one;
  };
  const History by_commit = make_history({dated("c", "2026-01-01T00:00:00Z", "2026-03-01T00:00:00Z"),
                                          dated("b", "2026-01-03T00:00:00Z", "2026-02-01T00:00:00Z"),
                                          dated("a", "2026-01-02T00:00:00Z", "2026-02-01T00:00:00Z")});
  EXPECT_EQ(names_of(by_commit), "a b c ");  // one commit's records as they were made
  EXPECT_TRUE(has(notes_of(by_commit), "order of their commits' dates"));
  HistoryRecord unknown = dated("a", "2026-01-02T00:00:00Z", "");
  unknown.record.run["commit_date"] = nullptr;
  const History by_run = make_history({dated("b", "2026-01-03T00:00:00Z", "2026-01-01T00:00:00Z"), unknown});
  EXPECT_EQ(names_of(by_run), "a b ");
  EXPECT_TRUE(has(notes_of(by_run), "order in which they were made"));
  const History as_given = make_history({dated("b", "", ""), dated("a", "2026-01-02T00:00:00Z", "")});
  EXPECT_EQ(names_of(as_given), "b a ");
  EXPECT_TRUE(has(notes_of(as_given), "order given"));
}

TEST(History, FindsTheStepsOfCountsAtOnceAndOfTimesOverNoise) {
  std::vector<HistoryRecord> records;
  for (int i = 0; i < 12; ++i)
    records.push_back(
        record_named(std::string(1, static_cast<char>('a' + i)), (i < 6 ? 5 : 6) + 0.01 * (i % 3), i < 11 ? 1500 : 1600));
  const History history = make_history(records);
  const Trend* frame = trend_of(history, "vertex_normal", "frame");
  ASSERT_EQ(frame->steps.size(), 1u);
  EXPECT_EQ(frame->steps[0].point, 6u);
  EXPECT_DOUBLE_EQ(frame->steps[0].before, 5.01);
  EXPECT_DOUBLE_EQ(frame->steps[0].after, 6.01);
  EXPECT_FALSE(frame->steps[0].elsewhere);
  const Trend* fetches = trend_of(history, "vertex_normal", "fetches");
  ASSERT_EQ(fetches->steps.size(), 1u);
  EXPECT_EQ(fetches->steps[0].point, 11u);
  EXPECT_TRUE(trend_of(history, "light_map", "frame")->steps.empty());

  const std::string table = history_table(history, false);
  EXPECT_TRUE(has(table, "vertex_normal on vulkan, view front: frame ms 5.010 -> 6.010 (+20.0%) at commit commit_g (g)"))
      << table;
  EXPECT_TRUE(has(table, "fetches 1500 -> 1600 (+6.7%) at commit commit_l (l)")) << table;
  EXPECT_TRUE(has(table, "unchanged: SSIM 0.9000, PSNR 30.0 dB, FLIP 0.1000")) << table;
  EXPECT_TRUE(has(table, "▁▁▁▁▁▁")) << table;
  EXPECT_FALSE(has(table, "\x1b"));
  EXPECT_TRUE(has(history_table(history, true), "\x1b[31m"));
}

TEST(History, SaysWhereNothingChanged) {
  EXPECT_TRUE(
      has(history_table(make_history({record_named("a"), record_named("b")}), false), "no steps: nothing changed for good"));
}

TEST(History, KeepsFrameTimesOfMachinesApartAndSaysWhereAStepIsOfAnother) {
  std::vector<HistoryRecord> records = {record_named("a"), record_named("b"), record_named("c", 9, 1700),
                                        record_named("d", 9, 1700)};
  for (size_t i = 2; i < 4; ++i) records[i].record.run["machine"]["cpu"] = "Other CPU";
  const History history = make_history(records);
  ASSERT_TRUE(trend_of(history, "vertex_normal", "frame", "Example CPU"));
  EXPECT_EQ(trend_of(history, "vertex_normal", "frame", "Example CPU")->points.size(), 2u);
  EXPECT_EQ(trend_of(history, "vertex_normal", "frame", "Other CPU")->points.size(), 2u);
  EXPECT_EQ(trend_of(history, "vertex_normal", "ratio to baseline")->points.size(), 4u);
  const Trend* fetches = trend_of(history, "vertex_normal", "fetches");
  ASSERT_EQ(fetches->steps.size(), 1u);
  EXPECT_TRUE(fetches->steps[0].elsewhere);
  const std::string table = history_table(history, false);
  EXPECT_TRUE(has(table, "machine A: Example CPU")) << table;
  EXPECT_TRUE(has(table, "frame ms on machine B")) << table;
  EXPECT_TRUE(has(table, "the machine or driver changed here too")) << table;
}

TEST(History, TakesNoTimesOfOtherBuildsOrWithoutACertificateOrOfFailedCells) {
  HistoryRecord debug = record_named("debug"), uncertified = record_named("uncertified"), failed = record_named("failed");
  debug.record.run["build"] = "dev";
  uncertified.record.timers.clear();
  failed.record.cells[1].failed = true;
  const History history = make_history({record_named("a"), debug, uncertified, failed, record_named("b")});
  EXPECT_EQ(trend_of(history, "vertex_normal", "frame")->points.size(), 2u);
  EXPECT_EQ(trend_of(history, "vertex_normal", "ratio to baseline")->points.size(), 2u);
  EXPECT_EQ(trend_of(history, "vertex_normal", "fetches")->points.size(), 4u);
  EXPECT_TRUE(has(notes_of(history), "debug: the build is not 'release'"));
  EXPECT_TRUE(has(notes_of(history), "failed: 1 of 2 cells failed"));
}

TEST(History, SaysWhatIsCutShortAndWhatDiffers) {
  HistoryRecord cut = record_named("cut"), other = record_named("other");
  cut.record.run["truncated"] = "line 9 is cut short";
  for (CellRow& cell : other.record.cells) cell.width = 128;
  const History history = make_history({record_named("a"), cut, other});
  EXPECT_TRUE(has(notes_of(history), "cut is used as far as it goes: line 9 is cut short"));
  EXPECT_TRUE(has(notes_of(history), "heart at 128x32 in 1 of 3 records"));
  EXPECT_TRUE(has(notes_of(history), "2 of 4 cells are in one record only"));
  EXPECT_EQ(trend_of(history, "vertex_normal", "fetches")->points.size(), 2u);
}

TEST(History, ParametersMakeCellsOfTheirOwn) {
  std::vector<HistoryRecord> records = {record_named("a"), record_named("b")};
  for (HistoryRecord& one : records) {
    CellRow thick = one.record.cells[1];
    thick.params["objects.heart.thickness"] = 9;
    one.record.cells.push_back(thick);
    one.record.cells.push_back(thick);
  }
  const History history = make_history(records);
  EXPECT_EQ(std::ranges::count_if(history.trends, [](const Trend& t) { return t.figure->name == "fetches"; }), 3);
  EXPECT_TRUE(has(notes_of(history), "twice; the first is used"));
}

TEST(History, IdenticalPicturesHaveInfinitePsnr) {
  std::vector<HistoryRecord> records = {record_named("a"), record_named("b"), record_named("c")};
  records[2].record.cells[1].error_covered->psnr_db = std::numeric_limits<double>::infinity();
  const History history = make_history(records);
  const Trend* psnr = trend_of(history, "vertex_normal", "PSNR");
  ASSERT_EQ(psnr->steps.size(), 1u);
  EXPECT_EQ(psnr->steps[0].after, std::numeric_limits<double>::infinity());
  EXPECT_TRUE(has(history_table(history, false), "PSNR dB 30.0 -> inf")) << history_table(history, false);
  EXPECT_TRUE(has(history_csv(history), ",inf,1,30,inf\r\n")) << history_csv(history);
}

TEST(History, RefusesWhatHasNoTrend) {
  EXPECT_TRUE(has(refusal({record_named("a")}), "two records or more"));
  HistoryRecord other = record_named("other");
  for (CellRow& cell : other.record.cells) cell.scene = "terrain";
  EXPECT_TRUE(has(refusal({record_named("a"), other}), "no cell in common"));
  HistoryRecord failed = record_named("failed");
  for (CellRow& cell : failed.record.cells) cell.failed = true;
  EXPECT_TRUE(has(refusal({record_named("a"), failed}), "no figure in common"));
}

TEST(HistoryCsv, HasALineAPointAndQuotesWhatItMust) {
  std::vector<HistoryRecord> records = {record_named("a,1"), record_named("b", 5, 1600)};
  const std::string csv = history_csv(make_history(records));
  EXPECT_TRUE(
      csv.starts_with("scene,effect,variant,backend,view,width,height,params,figure,unit,machine,record,commit,date,value,"
                      "step,before,after\r\n"))
      << csv;
  EXPECT_TRUE(has(csv,
                  "heart,layered_material,vertex_normal,vulkan,front,64,32,scene.time 0.5,fetches,,,\"a,1\",\"commit_a,1\",,"
                  "1500,0,,\r\n"))
      << csv;
  EXPECT_TRUE(has(csv, ",fetches,,,b,commit_b,,1600,1,1500,1600\r\n")) << csv;
}

}  // namespace
}  // namespace lamina
