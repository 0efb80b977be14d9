// SPDX-License-Identifier: Apache-2.0
// The answer that a report begins with: what is worth having, what is dominated and by what, what is not known.
#include <gtest/gtest.h>

#include "reports/words.h"
#include "tests/reports/example_record.h"

namespace lamina {
namespace {

std::vector<Headline> answers_of(const std::vector<CellRow>& cells, const std::vector<TimerRow>& timers) {
  return worth_having(summarize(example_record(cells, timers)));
}

TEST(Answers, SayWhatIsWorthHavingAndWhatIsDominated) {
  std::vector<CellRow> cells = example_cells();
  cells.push_back(example_cell("normal_map_taps", "front", {9, 9, 9, 9, 9, 9}));
  cells.push_back(example_cell("normal_map_taps", "grazing", {13, 13, 13, 13, 13, 13}));
  const auto all = answers_of(cells, {example_timer("vulkan")});
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].variant, "layered_material");
  EXPECT_EQ(all[0].words,
            "worth having, by time and SSIM to the baseline: light_map (the baseline) and vertex_normal (SSIM 0.9000). "
            "Dominated, since another "
            "is closer and at most 2% slower: normal_map_taps (by light_map).");
}

TEST(Answers, NameTheBackendsWhereTheyDisagree) {
  std::vector<CellRow> cells;
  for (const auto& [backend, fast_ms] : {std::pair{"vulkan", 4.0}, {"osmesa", 9.0}}) {
    cells.push_back(example_cell("light_map", "front", std::vector<double>(6, 8), backend));
    cells.push_back(example_cell("vertex_normal", "front", std::vector<double>(6, fast_ms), backend));
    cells.push_back(example_cell("normal_map_taps", "front", std::vector<double>(6, 20), backend));
  }
  const auto all = answers_of(cells, {example_timer("vulkan"), example_timer("osmesa")});
  ASSERT_EQ(all.size(), 1u);
  EXPECT_TRUE(has(all[0].words, "baseline: light_map (the baseline) and vertex_normal (SSIM 0.9000) on vulkan. Dominated"))
      << all[0].words;
  EXPECT_TRUE(has(all[0].words, "vertex_normal (by light_map on osmesa)")) << all[0].words;
  EXPECT_TRUE(has(all[0].words, "normal_map_taps (by light_map on both backends)")) << all[0].words;
}

TEST(Answers, WeighAgainstTheTruthToo) {
  std::vector<CellRow> cells = example_cells();
  for (CellRow& cell : cells)
    cell.error_truth =
        ErrorFigures{.psnr_db = 20, .ssim = cell.baseline ? 0.7 : 0.8, .flip = 0.25, .rmse_linear = 0.1, .max_linear = 0.5};
  const auto all = answers_of(cells, {example_timer("vulkan")});
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[1].words,
            "worth having, by time and SSIM to the truth: vertex_normal (SSIM 0.8000). Dominated, since another is closer and "
            "at most 2% slower: light_map (by vertex_normal).");
}

TEST(Answers, TwoThatAreNearlyAlikeAreToldApart) {
  std::vector<CellRow> cells = example_cells();
  for (CellRow* cell : {&cells[2], &cells[3]}) cell->error_covered->ssim = 0.999994;
  cells.push_back(example_cell("normal_map_taps", "front", {7, 7, 7, 7, 7, 7}));
  cells.push_back(example_cell("normal_map_taps", "grazing", {9, 9, 9, 9, 9, 9}));
  for (CellRow* cell : {&cells[4], &cells[5]}) cell->error_covered->ssim = 0.999996;
  EXPECT_TRUE(has(answers_of(cells, {example_timer("vulkan")})[0].words,
                  "vertex_normal (SSIM 0.999994) and normal_map_taps (SSIM 0.999996)."));
}

TEST(Answers, FetchesAreWeighedWhereNothingIsTimed) {
  const auto all = answers_of(example_cells(), {});
  ASSERT_EQ(all.size(), 1u);
  EXPECT_TRUE(has(all[0].words, "by fetches and SSIM")) << all[0].words;
  EXPECT_TRUE(has(all[0].words, "no more expensive: vertex_normal (by light_map)")) << all[0].words;
}

TEST(Answers, AVariantThatFailedIsNotKnown) {
  std::vector<CellRow> cells = example_cells();
  cells.push_back(example_cell("lost", "front", {}));
  cells.back().failed = true;
  EXPECT_TRUE(
      has(answers_of(cells, {example_timer("vulkan")})[0].words, "Not known (failed, not timed or without figures): lost."));
}

TEST(Answers, ABaselineThatFailedInAViewIsNoPerfectPicture) {
  std::vector<CellRow> cells = example_cells();
  EXPECT_FALSE(answers_of(cells, {example_timer("vulkan")}).empty());
  cells[0].failed = true;
  EXPECT_TRUE(answers_of(cells, {example_timer("vulkan")}).empty()) << "one variant with figures is nothing to weigh";
}

TEST(Answers, SayWhatIsNotToldApartAndWhatWouldTell) {
  std::vector<CellRow> cells = example_cells();
  cells.push_back(example_cell("normal_map_taps", "front", {7, 7, 9, 7, 9, 9}));
  cells.push_back(example_cell("normal_map_taps", "grazing", {11, 11, 13, 11, 13, 13}));
  for (CellRow* cell : {&cells[4], &cells[5]}) cell->error_covered->ssim = 0.95;
  const std::string words = answers_of(cells, {example_timer("vulkan")}).at(0).words;
  EXPECT_TRUE(has(words,
                  "Not told apart in time, so that more rounds are needed (--precision, --budget): normal_map_taps (from "
                  "light_map)."))
      << words;
}

TEST(Answers, WhatIsBeyondTheLimitIsShownAndNotRecommended) {
  Record record = example_record(example_cells());
  EXPECT_TRUE(has(worth_having(summarize(record)).at(0).words, "vertex_normal (SSIM 0.9000)."));
  record.run["settings"]["limits"] = {{"ssim", 0.95}};
  const std::vector<SummaryRow> rows = summarize(record);
  const std::string words = worth_having(rows).at(0).words;
  EXPECT_TRUE(has(words,
                  "baseline: light_map (the baseline). Beyond the limit of error, and not recommended: vertex_normal "
                  "(SSIM 0.9000, limit 0.95)."))
      << words;
  EXPECT_EQ(trouble_of(rows.at(1)), "not recommended: SSIM 0.9000, limit 0.95");
  EXPECT_EQ(limit_words(record), (std::vector<std::string>{"SSIM of at least 0.95"}));
}

TEST(Headlines, WhatIsNotAPictureIsSaidAndIsNeverFast) {
  std::vector<CellRow> cells = example_cells();
  for (CellRow* cell : {&cells[2], &cells[3]}) {
    cell->failed = true, cell->reason = "not a picture: 617 of 2048 pixels are not finite numbers, the first at (32, 0)";
    cell->error_covered.reset(), cell->error_frame.reset();
  }
  const Record record = example_record(cells);
  const std::vector<SummaryRow> rows = summarize(record);
  EXPECT_EQ(failure_headlines(rows).at(0).words,
            "is not a picture on vulkan: 617 of 2048 pixels are not finite numbers, the first at (32, 0).");
  EXPECT_TRUE(has(terminal_table(record, false), "not a picture"));
  EXPECT_TRUE(worth_having(rows).empty());
}

}  // namespace
}  // namespace lamina
