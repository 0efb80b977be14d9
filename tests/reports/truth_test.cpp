// SPDX-License-Identifier: Apache-2.0
// What the reports make of a truth, and of what was baked.
#include <gtest/gtest.h>

#include "reports/html/html.h"
#include "tests/reports/example_record.h"

namespace lamina {
namespace {

ErrorFigures figures(double rmse, double psnr_db = 20) {
  return {.psnr_db = psnr_db, .ssim = 0.8, .flip = 0.25, .rmse_linear = rmse, .max_linear = 0.5};
}

std::vector<CellRow> cells_with_truth() {
  std::vector<CellRow> cells = example_cells();
  for (CellRow& cell : cells) {
    cell.error_truth = figures(cell.view == "front" ? 0.125 : 0.375, cell.baseline ? 41 : 21);
    cell.truth_image = "images/truth-" + cell.view + ".png";
    cell.assumptions = {
        {.name = "intersection", .title = "approximate intersection", .error = figures(0.01), .image = "images/i.png"},
        {.name = "cosine", .title = "one cosine", .error = figures(0.03), .image = "images/c.png"},
        {.name = "aperture", .title = "one aperture", .error = figures(0.02), .image = "images/a.png"}};
  }
  return cells;
}

TEST(Truth, IsSummedUpOverViewsLikeTheBaseline) {
  const std::vector<SummaryRow> rows = summarize(example_record(cells_with_truth()));
  ASSERT_TRUE(rows[0].mean_to_truth);
  EXPECT_FALSE(rows[0].mean);
  EXPECT_DOUBLE_EQ(rows[0].mean_to_truth->rmse_linear, 0.25);
  EXPECT_DOUBLE_EQ(rows[0].worst_to_truth->rmse_linear, 0.375);
  EXPECT_NEAR(rows[0].mean_to_truth->psnr_db, 41, 1e-9);
  EXPECT_NEAR(rows[1].mean_to_truth->psnr_db, 21, 1e-9);
  EXPECT_DOUBLE_EQ(rows[1].mean->rmse_linear, 0.02);
}

TEST(Truth, TheTableHasItsColumnsOnlyWhereThereIsOne) {
  const Record with = example_record(cells_with_truth()), without = example_record(example_cells());
  for (const std::string& text : {page_of(with), markdown_summary(with)}) {
    for (const char* part :
         {"PSNR dB to truth", "SSIM to truth", "FLIP to truth", "RMSE to truth", "41.0 (41.0)", "21.0 (21.0)", "0.25 (0.375)"})
      EXPECT_TRUE(has(text, part)) << part;
  }
  EXPECT_FALSE(has(page_of(without), "truth"));
  EXPECT_FALSE(has(markdown_summary(without), "truth"));
  EXPECT_TRUE(has(cells_csv(with), ",error.truth.rmse_linear,"));
  EXPECT_TRUE(has(cells_csv(with), ",0.375,"));
}

TEST(Truth, StandsBesideTheVariantsOnceAView) {
  const std::string page = page_of(example_record(cells_with_truth()));
  EXPECT_EQ(count_of(page, "src=\"./images/truth-front.png\""), 1u);
  EXPECT_EQ(count_of(page, "src=\"./images/truth-grazing.png\""), 1u);
  EXPECT_EQ(count_of(page, ">to truth: PSNR dB, SSIM, FLIP<"), 2u);
  EXPECT_LT(page.find("truth-front.png"), page.find("src=\"./images/light_map-front.png\""));
}

TEST(Truth, SaysWhichAssumptionCostsTheMostInEachViewOfEachVariant) {
  const std::string page = page_of(example_record(cells_with_truth()));
  EXPECT_TRUE(has(page, "<h2>Which assumption costs you</h2>"));
  EXPECT_EQ(
      count_of(page,
               "What costs the most: one cosine, RMSE 0.03; then one aperture, 0.02; then approximate intersection, 0.01."),
      4u);
  EXPECT_EQ(count_of(page, "<details><summary>vertex_normal</summary>"), 2u);
  EXPECT_EQ(count_of(page, "src=\"./images/c.png\""), 4u);
  EXPECT_TRUE(has(markdown_summary(example_record(cells_with_truth())),
                  "- vertex_normal on vulkan, view grazing: What costs the most: one cosine"));
  EXPECT_FALSE(has(page_of(example_record(example_cells())), "Which assumption"));
}

TEST(Truth, AssumptionsThatChangeNothingAreSaidSo) {
  std::vector<CellRow> cells = cells_with_truth();
  for (CellRow& cell : cells)
    for (AssumptionRow& row : cell.assumptions) row.error = {.psnr_db = INFINITY, .ssim = 1};
  const std::string page = page_of(example_record(cells));
  EXPECT_EQ(count_of(page, "No assumption changes this picture."), 4u);
  EXPECT_TRUE(has(page, "<td class=\"num\">inf</td>"));
}

TEST(Truth, ItsStringsAreEscapedAndItsPicturesStayRelative) {
  std::vector<CellRow> cells = cells_with_truth();
  for (CellRow& cell : cells) {
    cell.truth_image = "https://example.com/\"t.png";
    for (AssumptionRow& row : cell.assumptions) row.title = "<script>alert(1)</script>", row.image = "javascript:alert(2)";
  }
  const Record record = example_record(cells);
  const std::string page = page_of(record);
  EXPECT_FALSE(has(page, "<script>alert"));
  EXPECT_FALSE(has(page, "src=\"https:"));
  EXPECT_FALSE(has(page, "src=\"javascript:"));
  EXPECT_TRUE(has(page, "src=\"./https%3A//example.com/%22t.png\""));
  EXPECT_FALSE(has(markdown_summary(record), "<script>"));
}

TEST(Bakes, AreListedUnderWhatIsDoneOnce) {
  Record record = example_record(example_cells());
  BakeRow bake = {
      .effect = "aperture_lighting", .object = "<ground>", .what = "apertures", .points = 10, .rays = 3000000, .seconds = 2};
  record.bakes.push_back(read_back(bake));
  bake.from_cache = true, bake.seconds = 0.25;
  record.bakes.push_back(read_back(bake));
  const std::string page = page_of(record), markdown = markdown_summary(record);
  for (const std::string& text : {page, markdown}) {
    EXPECT_TRUE(has(text, "What is done once"));
    EXPECT_TRUE(
        has(text, "apertures of &lt;ground&gt; (aperture_lighting): 10 points, 3000000 rays, 2 s, 1.5 million rays a second"));
    EXPECT_TRUE(has(text, "from the cache in 0.25 s"));
    EXPECT_EQ(count_of(text, "rays a second"), 1u);
  }
  EXPECT_FALSE(has(page_of(example_record(example_cells())), "What is done once"));
}

}  // namespace
}  // namespace lamina
