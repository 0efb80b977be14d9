// SPDX-License-Identifier: Apache-2.0
// A run against a stored record: what is compared on the same machine and on another, and which records are refused.
#include "harness/gate/stored.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "harness/core/error.h"
#include "tests/reports/example_record.h"

namespace lamina {
namespace {

Record record(double scale = 1, const std::string& variant = "vertex_normal") {
  std::vector<double> base, other;
  for (int i = 0; i < 40; ++i) base.push_back(10 * scale + 0.001 * i), other.push_back(5 * scale + 0.001 * i);
  CellRow changed = example_cell(variant, "front", other);
  if (variant != "light_map") changed.ratio_to_baseline = Interval{0.5, 0.499, 0.501, 40, 0.96};
  Record made = example_record({example_cell("light_map", "front", base), changed});
  made.run["time_s"] = 0.5;
  return made;
}
const VerdictRow* find(const std::vector<VerdictRow>& rows, std::string_view variant, std::string_view what) {
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const VerdictRow& row) { return row.variant == variant && row.what == what; });
  return found == rows.end() ? nullptr : &*found;
}

TEST(Stored, TheSameRunPasses) {
  const std::vector<VerdictRow> rows = judge_stored(record(), record(), {}, 0.05);
  EXPECT_EQ(outcome_of(rows).status, 0);
  EXPECT_EQ(find(rows, "vertex_normal", "time")->verdict, Verdict::same);
  EXPECT_EQ(find(rows, "vertex_normal", "ratio")->verdict, Verdict::same);
  EXPECT_FALSE(find(rows, "light_map", "ratio")) << "the baseline's own ratio is 1";
}

TEST(Stored, TimesBeyondTheDriftAreSlower) {
  const std::vector<VerdictRow> rows = judge_stored(record(), record(1.3), {}, 0.05);
  EXPECT_EQ(find(rows, "vertex_normal", "time")->verdict, Verdict::slower);
  EXPECT_EQ(outcome_of(rows).status, 1);
  EXPECT_EQ(outcome_of(judge_stored(record(), record(1.2), {}, 0.05)).status, 0);
}

TEST(Stored, AnotherMachineComparesRatiosAloneAndSaysSo) {
  for (const auto& [pointer, value] : std::vector<std::pair<std::string, nlohmann::json>>{{"/machine/cpu", "Other CPU"},
                                                                                          {"/devices/0/driver", "Mesa 25"},
                                                                                          {"/machine/lp_num_threads", "8"},
                                                                                          {"/build", "dev"}}) {
    Record now = record(3);
    now.run[nlohmann::json::json_pointer(pointer)] = value;
    std::vector<VerdictRow> rows = judge_stored(record(), now, {}, 0.05);
    EXPECT_EQ(outcome_of(rows).status, 0) << pointer;
    EXPECT_FALSE(find(rows, "vertex_normal", "time"));
    ASSERT_TRUE(find(rows, "", "time")) << "says so";
    EXPECT_EQ(find(rows, "", "time")->cause, Cause::another_machine);
    Interval& ratio = *now.cells[1].ratio_to_baseline;
    ratio.median = 0.55, ratio.low = 0.549, ratio.high = 0.551;
    EXPECT_EQ(find(judge_stored(record(), now, {}, 0.05), "vertex_normal", "ratio")->verdict, Verdict::slower);
  }
}

TEST(Stored, AChangedHashTellsOnTheSameMachineAlone) {
  Record now = record();
  now.cells[0].image_hash = "ffff";
  EXPECT_EQ(find(judge_stored(record(), now, {}, 0.05), "light_map", "picture")->verdict, Verdict::worse);
  now.run["devices"][0]["driver"] = "Mesa 25";
  EXPECT_FALSE(find(judge_stored(record(), now, {}, 0.05), "light_map", "picture"));
}

TEST(Stored, TimesOfZeroAreNoPass) {
  for (const bool in_record : {true, false}) {
    Record then = record(), now = record();
    for (CellRow& cell : (in_record ? then : now).cells)
      for (PassRow& pass : cell.passes) std::ranges::fill(pass.ms, 0.0);
    const std::vector<VerdictRow> rows = judge_stored(then, now, {}, 0.05);
    EXPECT_EQ(find(rows, "vertex_normal", "time")->verdict, Verdict::failed);
    EXPECT_EQ(outcome_of(rows).status, 1);
  }
}

// A busy machine leaves few rounds: nothing is known, which is no failure.
TEST(Stored, TooFewTimesAreAmbiguous) {
  Record now = record();
  for (CellRow& cell : now.cells)
    for (PassRow& pass : cell.passes) pass.ms = {5.0, 5.1, 5.0};
  const std::vector<VerdictRow> rows = judge_stored(record(), now, {}, 0.05);
  EXPECT_EQ(find(rows, "vertex_normal", "time")->verdict, Verdict::ambiguous);
  EXPECT_EQ(outcome_of(rows).status, 3);
}

TEST(Stored, AVanishedVariantFails) {
  Record now = record();
  now.cells.pop_back();
  const std::vector<VerdictRow> rows = judge_stored(record(), now, {}, 0.05);
  EXPECT_EQ(find(rows, "vertex_normal", "cell")->verdict, Verdict::failed);
}

TEST(Stored, RecordsThatCannotBeComparedAreRefused) {
  const auto refused = [](auto&& change, const std::string& words) {
    Record then = record();
    change(then);
    try {
      check_comparable(then, record(), "baseline.jsonl");
      ADD_FAILURE() << "taken; expected: " << words;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("baseline.jsonl"), std::string::npos);
    }
  };
  refused([](Record& then) { then.run["truncated"] = "line 7 is cut short"; }, "cut short");
  refused([](Record& then) { then.cells.clear(); }, "no cells");
  refused([](Record& then) { then.run["scene"] = "terrain"; }, "terrain");
  refused([](Record& then) { then.run["settings"]["width"] = 640; }, "width 640");
  refused([](Record& then) { then.run["time_s"] = 0.75; }, "moment");
  refused(
      [](Record& then) {
        for (CellRow& cell : then.cells) cell.backend = "egl";
      },
      "no cell in common");
  EXPECT_NO_THROW(check_comparable(record(), record(), "baseline.jsonl"));
}

}  // namespace
}  // namespace lamina
