// SPDX-License-Identifier: Apache-2.0
// The arithmetic of the summary, from its definitions.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "harness/shader/operations.h"
#include "reports/words.h"
#include "tests/reports/example_record.h"

namespace lamina {
namespace {

TEST(Summarize, MeansOverViewsByRoundThenTheMedian) {
  const std::vector<SummaryRow> rows = summarize(example_record(
      {example_cell("light_map", "front", {1, 2, 3, 4, 5, 60}), example_cell("light_map", "grazing", {50, 4, 3, 2, 1, 0})}));
  ASSERT_EQ(rows.size(), 1u);
  ASSERT_TRUE(rows[0].frame_ms);
  // Means by round: 25.5, 3, 3, 3, 3, 30. Each view alone has a median of 3.5 and 2.5.
  EXPECT_DOUBLE_EQ(rows[0].frame_ms->median, 3);
  EXPECT_DOUBLE_EQ(rows[0].frame_ms->low, 3);
  EXPECT_DOUBLE_EQ(rows[0].frame_ms->high, 30);
  EXPECT_EQ(rows[0].frame_ms->rounds, 6u);
  EXPECT_EQ(rows[0].views, 2u);
  EXPECT_FALSE(rows[0].ratio);
}

TEST(Summarize, RatioIsPairedByRoundOverAllViewsTogether) {
  // Both slow down together by the round. Sums: baseline 10 20 30 40 50 60, variant 5 10 15 20 25 36.
  const std::vector<SummaryRow> rows = summarize(example_record(
      {example_cell("vertex_normal", "front", {1, 2, 3, 4, 5, 6}),
       example_cell("vertex_normal", "grazing", {4, 8, 12, 16, 20, 30}),
       example_cell("light_map", "front", {9, 18, 27, 36, 45, 54}), example_cell("light_map", "grazing", {1, 2, 3, 4, 5, 6})}));
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].variant, "light_map");  // the baseline leads, though its cells came last
  ASSERT_TRUE(rows[1].ratio);
  EXPECT_DOUBLE_EQ(rows[1].ratio->median, 0.5);
  EXPECT_DOUBLE_EQ(rows[1].ratio->low, 0.5);
  EXPECT_DOUBLE_EQ(rows[1].ratio->high, 0.6);
  EXPECT_GE(rows[1].ratio->coverage, 0.95);
}

TEST(Summarize, RatioUsesOnlyViewsThatBothHave) {
  std::vector<CellRow> cells = example_cells();
  cells[0].failed = true;  // the baseline's front view
  const std::vector<SummaryRow> rows = summarize(example_record(cells));
  EXPECT_EQ(rows[0].failed_views, 1u);
  EXPECT_DOUBLE_EQ(rows[0].frame_ms->median, 12);
  EXPECT_DOUBLE_EQ(rows[1].ratio->median, 0.5);  // 6 of 12, not 10 of 12
  EXPECT_DOUBLE_EQ(rows[1].frame_ms->median, 5);
}

TEST(Summarize, PairsTheRoundsThatAllHave) {
  std::vector<CellRow> cells = example_cells();
  cells[2].passes[0].ms = {4, 4, 4, 4, 4, 4, 400};
  const std::vector<SummaryRow> rows = summarize(example_record(cells));
  EXPECT_EQ(rows[1].ratio->rounds, 6u);
  EXPECT_DOUBLE_EQ(rows[1].ratio->high, 0.5);
}

TEST(Summarize, FewRoundsGiveARangeThatSaysItsCoverage) {
  const std::vector<SummaryRow> rows = summarize(
      example_record({example_cell("light_map", "front", {2, 2, 2}), example_cell("vertex_normal", "front", {1, 3, 2})}));
  ASSERT_TRUE(rows[1].frame_ms);
  EXPECT_DOUBLE_EQ(rows[1].frame_ms->median, 2);
  EXPECT_DOUBLE_EQ(rows[1].frame_ms->low, 1);
  EXPECT_DOUBLE_EQ(rows[1].frame_ms->high, 3);
  EXPECT_DOUBLE_EQ(rows[1].frame_ms->coverage, 0.75);  // 1 - 2 / 2^3
  EXPECT_DOUBLE_EQ(rows[1].ratio->median, 1);
  EXPECT_DOUBLE_EQ(rows[1].ratio->high, 1.5);
}

TEST(Summarize, FetchesAreKnownWhereThoseOfEveryViewAre) {
  std::vector<CellRow> cells = example_cells();
  EXPECT_DOUBLE_EQ(*summarize(example_record(cells))[1].fetches_per_pixel, 15);
  cells[3].fetches.reset();
  EXPECT_FALSE(summarize(example_record(cells))[1].fetches_per_pixel) << "one view's are not all views'";
  cells[3].fetches = 1500, cells[3].failed = true;
  EXPECT_DOUBLE_EQ(*summarize(example_record(cells))[1].fetches_per_pixel, 15) << "failed views count in failed_views alone";
}

TEST(Warnings, AMissingCertificateIsOneWhereSomethingWasTimed) {
  std::vector<CellRow> cells = example_cells();
  ASSERT_EQ(warnings_of(example_record(cells, {})).size(), 1u);
  EXPECT_TRUE(has(warnings_of(example_record(cells, {}))[0], "no timer certificate of vulkan"));
  for (CellRow& cell : cells) cell.passes[0].ms.clear();
  EXPECT_TRUE(warnings_of(example_record(cells, {})).empty());
}

TEST(Summarize, WorkDoneOnceIsNotInTheFrame) {
  std::vector<CellRow> cells = example_cells();
  PassRow bake;
  bake.name = "bake";
  bake.once = true;
  bake.ms = {1000, 1000};
  cells[2].passes.push_back(bake);
  EXPECT_DOUBLE_EQ(summarize(example_record(cells))[1].ratio->median, 0.5);
}

TEST(Summarize, FetchesAPixelAreOverAllViewsPixels) {
  std::vector<CellRow> cells = example_cells();
  cells[2].fetches = 100, cells[2].covered_pixels = 10;   // 10 a pixel
  cells[3].fetches = 1800, cells[3].covered_pixels = 90;  // 20 a pixel
  EXPECT_DOUBLE_EQ(summarize(example_record(cells))[1].fetches_per_pixel.value(), 19);
}

TEST(Summarize, MeanAndWorstOfEachFigure) {
  std::vector<CellRow> cells = example_cells();
  cells[2].error_covered = ErrorFigures{.psnr_db = 20, .ssim = 0.8, .flip = 0.1, .rmse_linear = 0.4, .max_linear = 0.5};
  cells[3].error_covered = ErrorFigures{.psnr_db = 40, .ssim = 0.6, .flip = 0.3, .rmse_linear = 0.2, .max_linear = 0.9};
  cells[3].error_frame = ErrorFigures{};  // of no account
  const SummaryRow row = summarize(example_record(cells))[1];
  EXPECT_NEAR(row.mean->psnr_db, -10 * std::log10((1e-2 + 1e-4) / 2), 1e-12);
  EXPECT_DOUBLE_EQ(row.mean->ssim, 0.7);
  EXPECT_DOUBLE_EQ(row.mean->flip, 0.2);
  EXPECT_DOUBLE_EQ(row.mean->rmse_linear, 0.3);
  EXPECT_NEAR(row.mean->max_linear, 0.7, 1e-15);
  EXPECT_DOUBLE_EQ(row.worst->psnr_db, 20);  // each figure's own worst view: front, grazing, grazing, front, grazing
  EXPECT_DOUBLE_EQ(row.worst->ssim, 0.6);
  EXPECT_DOUBLE_EQ(row.worst->flip, 0.3);
  EXPECT_DOUBLE_EQ(row.worst->rmse_linear, 0.4);
  EXPECT_DOUBLE_EQ(row.worst->max_linear, 0.9);
  EXPECT_EQ(row.worst_view, "grazing");
}

TEST(Summarize, OneIdenticalViewDoesNotHideTheOthersLoss) {
  std::vector<CellRow> cells = example_cells();
  cells[2].error_covered->psnr_db = std::numeric_limits<double>::infinity();
  const SummaryRow one = summarize(example_record(cells))[1];
  EXPECT_NEAR(one.mean->psnr_db, 30 + 10 * std::log10(2.0), 1e-9);
  EXPECT_DOUBLE_EQ(one.worst->psnr_db, 30);
  cells[3].error_covered->psnr_db = std::numeric_limits<double>::infinity();
  const SummaryRow all = summarize(example_record(cells))[1];
  EXPECT_EQ(all.mean->psnr_db, std::numeric_limits<double>::infinity());
  EXPECT_EQ(all.worst->psnr_db, std::numeric_limits<double>::infinity());
}

TEST(Summarize, AFailedVariantIsARowWithoutFigures) {
  std::vector<CellRow> cells = example_cells();
  for (CellRow* cell : {&cells[2], &cells[3]}) {
    cell->failed = true;
    cell->reason = "shader: a.frag:3: no such name in " + cell->view;
    cell->error_covered = cell->error_frame = std::nullopt;
  }
  const SummaryRow row = summarize(example_record(cells))[1];
  EXPECT_EQ(row.views, 2u);
  EXPECT_EQ(row.failed_views, 2u);
  EXPECT_EQ(row.reason, "shader: a.frag:3: no such name in front");
  EXPECT_FALSE(row.frame_ms || row.ratio || row.fetches_per_pixel || row.mean || row.worst);
}

TEST(Summarize, NonFinitePixelsAreCountedAndSaid) {
  std::vector<CellRow> cells = example_cells();
  for (CellRow* cell : {&cells[2], &cells[3]}) {
    cell->nonfinite_pixels = 4;
    cell->error_covered = cell->error_frame = std::nullopt;
  }
  const Record record = example_record(cells);
  const SummaryRow row = summarize(record)[1];
  EXPECT_EQ(row.nonfinite_pixels, 8u);
  EXPECT_FALSE(row.mean || row.worst);
  for (const std::string& report : {terminal_table(record, false), markdown_summary(record), page_of(record)})
    EXPECT_TRUE(has(report, "8 pixels are not finite")) << report;
}

TEST(Summarize, WithoutAGoodCertificateThereAreNoTimes) {
  for (const std::vector<TimerRow>& timers : {std::vector<TimerRow>{},
                                              {example_timer("vulkan", false)},
                                              {example_timer("vulkan"), example_timer("vulkan", false)},
                                              {example_timer("osmesa")}}) {
    const SummaryRow row = summarize(example_record(example_cells(), timers))[1];
    EXPECT_FALSE(row.frame_ms || row.ratio);
    EXPECT_TRUE(row.mean);
    EXPECT_DOUBLE_EQ(row.fetches_per_pixel.value(), 15);
  }
}

TEST(Summarize, BackendsAreApart) {
  std::vector<CellRow> cells = example_cells();
  cells.push_back(example_cell("light_map", "front", {1, 1, 1, 1, 1, 1}, "osmesa"));
  cells.push_back(example_cell("vertex_normal", "front", {3, 3, 3, 3, 3, 3}, "osmesa"));
  const std::vector<SummaryRow> rows = summarize(example_record(cells, {example_timer("vulkan"), example_timer("osmesa")}));
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[3].backend, "osmesa");
  EXPECT_DOUBLE_EQ(rows[3].ratio->median, 3);
  EXPECT_DOUBLE_EQ(rows[1].ratio->median, 0.5);
}

TEST(SummarizePasses, MeansOverViewsAndFetchesByTexture) {
  std::vector<CellRow> cells = {example_cell("light_map", "front", {1, 2, 9}), example_cell("light_map", "grazing", {4, 4, 4})};
  cells[1].covered_pixels = 300;
  const std::vector<PassSummary> passes = summarize_passes(example_record(cells));
  ASSERT_EQ(passes.size(), 1u);
  EXPECT_DOUBLE_EQ(passes[0].ms.value(), 3);  // of the medians 2 and 4
  EXPECT_EQ(words_for_fragments(passes[0]), "120");
  EXPECT_DOUBLE_EQ(passes[0].fetches_per_pixel.value(), 7.5);  // 3000 over 400
  ASSERT_EQ(passes[0].shares.size(), 2u);
  EXPECT_EQ(words_for_share(passes[0].shares[0]), "light_map_texture (rgba16_float, linear) 6.5/px");
  EXPECT_EQ(words_for_share(passes[0].shares[1]), "outer_albedo (rgba8_srgb, trilinear) 1.0/px");
  EXPECT_TRUE(passes[0].operations.empty()) << "as in records from before they were counted";
  cells[0].passes[0].operations = {{"add", 1000}, {"exp", 100}}, cells[1].passes[0].operations = {{"add", 600}};
  const PassSummary counted = summarize_passes(example_record(cells))[0];
  EXPECT_EQ(counted.operations, (std::map<std::string, double>{{"add", 4}, {"exp", 0.25}}));  // over 400 pixels
  EXPECT_DOUBLE_EQ(counted.operations_per_pixel(), 4.25);
  cells[1].passes[0].early_tests = false;
  EXPECT_EQ(words_for_fragments(summarize_passes(example_record(cells))[0]), "120, hidden ones too");
}

TEST(SummarizePasses, MeanLevelsOfTheReadsThatAreCounted) {
  std::vector<CellRow> cells = {example_cell("light_map", "front", {1, 2, 9}), example_cell("light_map", "grazing", {4, 4, 4})};
  TextureFetches &first = cells[0].passes[0].by_texture[1], &second = cells[1].passes[0].by_texture[1];
  first.levels = {100, 100}, second.levels = {0, 0, 200};
  const auto words = [&] { return words_for_share(summarize_passes(example_record(cells))[0].shares[1]); };
  EXPECT_EQ(words(), "outer_albedo (rgba8_srgb, trilinear) 2.0/px, level 1.2") << "100 at 1 and 200 at 2, of 400";
  second.levels.clear();
  EXPECT_EQ(words(), "outer_albedo (rgba8_srgb, trilinear) 2.0/px") << "one view's are not all views'";
  std::swap(first.levels, second.levels);
  second.levels = {7};
  EXPECT_EQ(words(), "outer_albedo (rgba8_srgb, trilinear) 2.0/px") << "nor a later one's";
  first.dimensions = 3;
  EXPECT_EQ(words(), "outer_albedo (rgba8_srgb, trilinear, 3D) 2.0/px");
}

TEST(SummarizePasses, EveryClassOfOperationsHasAGroup) {
  for (size_t k = 0; k < operation_class_count; ++k)
    EXPECT_NE(operation_group(name_of(static_cast<OperationClass>(k))), "other") << name_of(static_cast<OperationClass>(k));
  EXPECT_EQ(operation_group("teleport"), "other") << "of a record from another version";
}

TEST(Warnings, HoldWhatCellsHaveToSayOnce) {
  std::vector<CellRow> cells = example_cells();
  for (CellRow& cell : cells) cell.notes = {"it covers no pixel"};
  cells.back().notes.push_back("8 layers were not enough");
  const std::vector<std::string> said = warnings_of(example_record(cells));
  EXPECT_EQ(said, (std::vector<std::string>{"it covers no pixel", cells.back().variant + ": 8 layers were not enough"}));
}

}  // namespace
}  // namespace lamina
