// SPDX-License-Identifier: Apache-2.0
// What is said of a frame that leaves out what nothing calls for, of a record made by hand.
#include <gtest/gtest.h>

#include "reports/html/html.h"
#include "tests/reports/example_record.h"

namespace lamina {
namespace {

SavingRow example_row(const std::string& view) {
  SavingRow row;
  row.scene = "heart", row.backend = "vulkan", row.device = "llvmpipe", row.view = view, row.width = 8, row.height = 4;
  const std::vector<double> two(6, 2), six(6, 6);
  row.effects = {
      {.effect = "skin",
       .called_for = true,
       .reason = "r",
       .culled = {.ms = two, .fetches = 100, .operations = 1000, .target_bytes = 1024},
       .all = {.ms = two, .fetches = 100, .operations = 1000, .target_bytes = 1024}},
      {.effect = "mist", .reason = "no fog", .all = {.ms = six, .fetches = 300, .operations = 7000, .target_bytes = 4096}},
      {.effect = "glass", .reason = "no glass", .cannot = "no object has it"}};
  row.culled_frame_bytes = 384, row.all_frame_bytes = 640, row.culled_texture_bytes = 2048, row.all_texture_bytes = 3072;
  row.ratio = Interval{.median = 0.25, .low = 0.25, .high = 0.25, .rounds = 6, .coverage = 0.96875};
  return row;
}
Record example_of(std::vector<SavingRow> rows, bool timer = true) {
  Record record = example_record({}, {example_timer("vulkan", timer)});
  record.savings = read_back(rows);
  return record;
}

TEST(Saving, IsToldOfTheFrameAndOfEachEffect) {
  const Record record = example_of({example_row("front"), example_row("side")});
  const std::vector<SavingBars> bars = saving_bars(record);
  ASSERT_EQ(bars.size(), 1u);
  ASSERT_EQ(bars[0].bars.size(), 2u) << "glass costs nothing in both";
  EXPECT_EQ(bars[0].bars[0].effect, "mist") << "it saves the most";
  EXPECT_EQ(bars[0].bars[0].culled, 0);
  EXPECT_EQ(bars[0].bars[0].all, 6);
  const std::string text = terminal_table(record, false);
  // 2 ms of 8.
  for (const char* part :
       {"the frame takes 0.250 [0.250, 0.250] of the time", "1 k operations in place of 8 k", "100 fetches in place of 400",
        "targets of 1.38 KiB in place of 5.62 KiB", "the pictures of both frames are the same to the bit in every view",
        "glass has no part in it: no object has it"})
    EXPECT_TRUE(has(text, part)) << part << "\n" << text;
  EXPECT_TRUE(has(markdown_summary(record), "What is left out, and what that saves"));
}

TEST(Saving, WithoutAGoodTimerNoTimeIsShown) {
  const Record record = example_of({example_row("front")}, false);
  EXPECT_FALSE(saving_bars(record)[0].timed);
  EXPECT_EQ(saving_bars(record)[0].bars[0].all, 7000) << "operations";
  EXPECT_FALSE(has(terminal_table(record, false), "of the time"));
}

TEST(Saving, PicturesThatDifferAreSaid) {
  SavingRow row = example_row("front");
  row.different_pixels = 3, row.largest_difference = 0.5, row.where = "pixel 1, 2 of 8x4, by mist";
  const std::string text = terminal_table(example_of({row, example_row("side")}), false);
  EXPECT_TRUE(has(text, "view front: 3 pixels DIFFER between the two frames, by 0.5 at most, at pixel 1, 2 of 8x4, by mist"))
      << text;
  EXPECT_FALSE(has(text, "the same to the bit"));
}

TEST(Saving, AFailureHasNoFigures) {
  SavingRow row;
  row.backend = "osmesa", row.view = "front", row.failure = "no device";
  const Record record = example_of({row});
  EXPECT_TRUE(saving_tables(record).empty());
  EXPECT_TRUE(has(terminal_table(record, false), "no figures: no device"));
}

TEST(Saving, RoundsArePaired) {
  SavingRow row = example_row("front");
  row.effects[0].all.ms.pop_back();
  EXPECT_THROW(read_back(row), Error);
}

TEST(TargetMemoryWords, TellTheBytesAloneAndWithSharing) {
  std::vector<CellRow> cells = example_cells();
  for (CellRow& cell : cells) cell.memory_bytes = 3 << 20, cell.memory_bytes_alone = 5 << 20;
  cells[0].baseline = true;
  Record record = example_record(cells);
  record.plans = {{}};
  EXPECT_EQ(memory_lines(record).size(), 1u) << "a plan of before tells none";
  PlanRow::Frame frame;
  frame.targets = {{.target = "a", .bytes = 4096}, {.target = "b", .bytes = 2048}};
  frame.aliased_bytes = 4096, frame.reused_bytes = 5120;
  record.plans.front().frame = frame;
  const std::vector<std::string> lines = memory_lines(record);
  ASSERT_EQ(lines.size(), 2u) << "a line of the plan, and one a backend";
  for (const char* part : {"6.00 KiB each alone", "4.00 KiB on Vulkan", "5.00 KiB on OpenGL"})
    EXPECT_TRUE(has(lines[0], part)) << lines[0];
  for (const char* part : {"vulkan: ", "light_map", "3.00 MiB", "5.00 MiB if each"})
    EXPECT_TRUE(has(lines[1], part)) << lines[1];
  EXPECT_TRUE(has(page_of(record), "<h3>What targets take</h3>"));
}

TEST(FrameGraph, ShowsWhoWritesAndReadsAndWhatIsLeftOut) {
  Record record = example_record(example_cells());
  EXPECT_EQ(html_frame_graph(record), "") << "a record of before has none";
  PlanRow plan;
  plan.effects = {{.effect = "water", .reason = "no <water>"}};
  PlanRow::Frame frame;
  frame.passes = {{.pass = "sum", .effect = "mist"}, {.pass = "other", .effect = "mist"}, {.pass = "show", .effect = "mist"}};
  frame.targets = {{.target = "thickness", .effect = "mist", .writers = {0}, .readers = {2}, .bytes = 2048}};
  plan.frame = frame;
  record.plans = {plan};
  const std::string html = page_of(record);
  for (const char* part :
       {"<th>1. mist: sum</th><td class=\"touch writes\"><span>writes</span></td>",
        "<th>2. mist: other</th><td class=\"alive\"></td>", "<th>3. mist: show</th><td class=\"touch\"><span>reads</span></td>",
        "thickness <small>2.00 KiB</small>", "not called for: no &lt;water&gt;"})
    EXPECT_TRUE(has(html, part)) << part;
}

}  // namespace
}  // namespace lamina
