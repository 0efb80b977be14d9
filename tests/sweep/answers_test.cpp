// SPDX-License-Identifier: Apache-2.0
// Curves given by formulas, whose crossovers can be worked out on paper.
#include "harness/sweep/answers.h"

#include <gtest/gtest.h>

#include "harness/core/error.h"
#include "tests/sweep/sweep_cells.h"

namespace lamina {
namespace {

std::vector<double> whole_numbers(int last) {
  std::vector<double> x;
  for (int i = 0; i <= last; ++i) x.push_back(i);
  return x;
}

// vertex_normal: SSIM 1 - x / 310, so 0.98 at 6.2; ratio 0.2 + x / 20. normal_map_taps: SSIM 0.97 throughout, met at 9.3;
// ratio 0.5, met at 6.
std::vector<CellRow> crossing_cells(bool timed) {
  std::vector<CellRow> cells;
  const auto ratio = [&](double value) { return timed ? std::optional(value) : std::nullopt; };
  for (const double x : whole_numbers(16)) {
    cells.push_back(sweep_cell("light_map", x, 1, ratio(1)));
    cells.push_back(sweep_cell("vertex_normal", x, 1 - x / 310, ratio(0.2 + x / 20)));
    cells.push_back(sweep_cell("normal_map_taps", x, 0.97, ratio(0.5)));
  }
  return cells;
}

const CrossoverRow* find(const std::vector<CrossoverRow>& rows, const std::string& variant, const std::string& other,
                         const std::string& metric) {
  for (const CrossoverRow& row : rows)
    if (row.variant == variant && row.other == other && row.metric == metric) return &row;
  return nullptr;
}

// The sentence holds these.
void expect_says(const CrossoverRow& row, const std::vector<std::string>& parts) {
  for (const std::string& part : parts)
    EXPECT_NE(row.sentence.find(part), std::string::npos) << part << " in: " << row.sentence;
}

TEST(Answers, AVariantKeepsItsLimitUpToTheCrossing) {
  const auto rows = answers(curves_of(sweep_record(whole_numbers(16), crossing_cells(false))), {{"ssim", 0.98}});
  const CrossoverRow* row = find(rows, "vertex_normal", "", "ssim");
  ASSERT_TRUE(row);
  EXPECT_NEAR(*row->at, 6.2, 1e-9);
  EXPECT_NEAR(row->tolerance, 0, 1e-6);  // a straight line
  EXPECT_EQ(row->limit, 0.98);
  EXPECT_EQ(row->variant, "vertex_normal");
  EXPECT_NE(row->sentence.find("keeps SSIM at least 0.98 up to thickness 6.2 texels"), std::string::npos) << row->sentence;
  const CrossoverRow* never = find(rows, "normal_map_taps", "", "ssim");
  ASSERT_TRUE(never);
  EXPECT_FALSE(never->at);
  expect_says(*never, {"normal_map_taps does not keep", "0.98", "thickness 0 to 16 texels", "vulkan"});
}

TEST(Answers, FlipIsKeptFromAbove) {
  const auto rows = answers(curves_of(sweep_record(whole_numbers(16), crossing_cells(false))), {{"flip", 0.02}});
  const CrossoverRow* row = find(rows, "vertex_normal", "", "flip");
  ASSERT_TRUE(row);
  EXPECT_NEAR(*row->at, 6.2, 1e-9);
  EXPECT_NE(row->sentence.find("keeps FLIP at most 0.02 up to"), std::string::npos) << row->sentence;
}

TEST(Answers, BetterFromWhereTheCurvesMeet) {
  const auto rows = answers(curves_of(sweep_record(whole_numbers(16), crossing_cells(false))), {{"ssim", 0.98}});
  const CrossoverRow* row = find(rows, "normal_map_taps", "vertex_normal", "ssim");
  ASSERT_TRUE(row);
  EXPECT_NEAR(*row->at, 9.3, 1e-9);
  EXPECT_NE(row->sentence.find("is better by SSIM than vertex_normal from thickness 9.3 texels"), std::string::npos)
      << row->sentence;
  EXPECT_FALSE(find(rows, "normal_map_taps", "vertex_normal", "ratio")) << "nothing was timed";
  EXPECT_FALSE(find(rows, "normal_map_taps", "vertex_normal", "ssim,ratio"));
}

TEST(Answers, BothCheaperAndBetterFromTheLaterOfTheTwo) {
  const auto rows = answers(curves_of(sweep_record(whole_numbers(16), crossing_cells(true))), {{"ssim", 0.98}});
  const CrossoverRow* cheaper = find(rows, "normal_map_taps", "vertex_normal", "ratio");
  const CrossoverRow* both = find(rows, "normal_map_taps", "vertex_normal", "ssim,ratio");
  ASSERT_TRUE(cheaper && both);
  EXPECT_NEAR(*cheaper->at, 6, 1e-9);
  EXPECT_NEAR(*both->at, 9.3, 1e-9);
  EXPECT_NE(both->sentence.find("is both cheaper and better by SSIM than vertex_normal from"), std::string::npos)
      << both->sentence;
  const CrossoverRow* baseline = find(rows, "vertex_normal", "light_map", "ratio");
  ASSERT_TRUE(baseline);
  EXPECT_FALSE(baseline->at) << "its ratio reaches 1 at the last point, and crosses it nowhere";
  EXPECT_NE(baseline->sentence.find("is cheaper than light_map over thickness 0 to 15 texels"), std::string::npos)
      << baseline->sentence;
}

TEST(Answers, EqualPicturesAtOneEndAreNoCrossing) {
  std::vector<CellRow> cells;
  for (const double x : whole_numbers(4)) {
    cells.push_back(sweep_cell("vertex_normal", x, 1 - x / 100));
    cells.push_back(sweep_cell("normal_map_taps", x, 1 - x / 50));
  }
  const auto rows = answers(curves_of(sweep_record(whole_numbers(4), cells)), {{"ssim", 0.5}});
  const CrossoverRow* row = find(rows, "vertex_normal", "normal_map_taps", "ssim");
  ASSERT_TRUE(row);
  EXPECT_FALSE(row->at) << row->sentence;
  EXPECT_FALSE(find(rows, "normal_map_taps", "vertex_normal", "ssim"));
}

// Alike at 0 and 1, apart from 2 on: what is said of the rest does not reach there.
TEST(Answers, WhereTwoAreAlikeIsTold) {
  std::vector<CellRow> cells;
  for (const double x : whole_numbers(4)) {
    cells.push_back(sweep_cell("light_map", x, 1, 1));
    cells.push_back(sweep_cell("vertex_normal", x, 0.9, x < 2 ? 0.5 : 0.25));
    cells.push_back(sweep_cell("normal_map_taps", x, x < 2 ? 0.9 : 0.8, 0.5));
  }
  const auto rows = answers(curves_of(sweep_record(whole_numbers(4), cells)), {{"ssim", 0.5}});
  const CrossoverRow* better = find(rows, "vertex_normal", "normal_map_taps", "ssim");
  const CrossoverRow* cheaper = find(rows, "vertex_normal", "normal_map_taps", "ratio");
  const CrossoverRow* both = find(rows, "vertex_normal", "normal_map_taps", "ssim,ratio");
  ASSERT_TRUE(better && cheaper && both);
  const char *where = "normal_map_taps over thickness 2 to 4 texels on vulkan", *overlap = "2 of 5 timed points";
  expect_says(*better, {"vertex_normal is better by SSIM", where, "2 of 5 points they are equal"});
  expect_says(*cheaper, {"vertex_normal is cheaper", where, overlap});
  expect_says(*both, {"vertex_normal is both cheaper and better by SSIM", where, "2 of 5 points they are equal", overlap});
}

// Better from 2 on, but timed at 8 and 16 alone: both is known from 8 on.
TEST(Answers, BothIsNotToldWhereNothingWasTimed) {
  std::vector<CellRow> cells;
  for (const double x : whole_numbers(16)) {
    const bool timed = x == 8 || x == 16;
    const auto ratio = [&](double value) { return timed ? std::optional(value) : std::nullopt; };
    cells.push_back(sweep_cell("vertex_normal", x, 0.9 + x / 1000, ratio(0.25)));
    cells.push_back(sweep_cell("normal_map_taps", x, 0.902, ratio(0.5)));
  }
  const auto rows = answers(curves_of(sweep_record(whole_numbers(16), cells)), {{"ssim", 0.5}});
  const CrossoverRow* both = find(rows, "vertex_normal", "normal_map_taps", "ssim,ratio");
  ASSERT_TRUE(both);
  EXPECT_NE(both->sentence.find("over thickness 8 to 16 texels"), std::string::npos) << both->sentence;
}

// Of an order that holds everywhere neighbours are told, and what each is to the baseline; a crossing is told once.
TEST(Answers, WhatFollowsFromOtherAnswersIsLeftOut) {
  std::vector<CellRow> cells;
  for (const double x : whole_numbers(4)) {
    cells.push_back(sweep_cell("light_map", x, 1, 1));
    cells.push_back(sweep_cell("first", x, 0.9, 0.25));
    cells.push_back(sweep_cell("second", x, 0.8, 0.5));
    cells.push_back(sweep_cell("third", x, 0.7, 0.75));
    cells.push_back(sweep_cell("steep", x, 0.95 - x / 10, 0.9));  // as good as first at 0.5, as second at 1.5, as third at 2.5
  }
  const auto rows = answers(curves_of(sweep_record(whole_numbers(4), cells)), {{"ssim", 0.5}});
  for (const char* metric : {"ssim", "ratio", "ssim,ratio"}) {
    EXPECT_TRUE(find(rows, "first", "second", metric)) << metric;
    EXPECT_TRUE(find(rows, "second", "third", metric)) << metric;
    EXPECT_FALSE(find(rows, "first", "third", metric)) << metric;
  }
  for (const char* variant : {"first", "second", "third"}) EXPECT_TRUE(find(rows, variant, "light_map", "ratio")) << variant;
  for (const char* variant : {"first", "second", "third"}) {
    EXPECT_TRUE(find(rows, variant, "steep", "ssim")) << variant;
    EXPECT_FALSE(find(rows, "steep", variant, "ssim")) << variant;
  }
}

// The baseline has errors against the truth too.
TEST(Answers, AgainstTheTruthTheBaselineIsOneOfThem) {
  std::vector<CellRow> cells;
  for (const double x : whole_numbers(4))
    for (const char* variant : {"light_map", "vertex_normal"}) {
      CellRow& cell = cells.emplace_back(sweep_cell(variant, x, 0.9));
      cell.error_truth =
          ErrorFigures{.psnr_db = 40, .ssim = cell.baseline ? 1 - x / 10 : 0.85, .flip = 0, .rmse_linear = 0, .max_linear = 0};
    }
  const auto rows = answers(curves_of(sweep_record(whole_numbers(4), cells)), {{"truth.ssim", 0.75}});
  const CrossoverRow *kept = find(rows, "light_map", "", "truth.ssim"),
                     *better = find(rows, "vertex_normal", "light_map", "truth.ssim");
  ASSERT_TRUE(kept && better);
  EXPECT_NEAR(*kept->at, 2.5, 1e-9);
  EXPECT_NEAR(*better->at, 1.5, 1e-9);
}

TEST(Answers, AFailedCellIsAGapThatIsTold) {
  std::vector<CellRow> cells;
  for (const double x : whole_numbers(4)) cells.push_back(sweep_cell("vertex_normal", x, 1 - x / 100));
  cells[2].failed = true, cells[2].reason = "lost";
  const auto rows = answers(curves_of(sweep_record(whole_numbers(4), cells)), {{"ssim", 0.985}});
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_FALSE(rows[0].at);
  EXPECT_NE(rows[0].sentence.find("1 of 5 points are missing"), std::string::npos) << rows[0].sentence;
}

TEST(Answers, WhatIsHeldIsToldWithItsUnitAndItsOwnerWhereNamesMeet) {
  Curve curve;
  curve.backend = "vulkan", curve.parameter = thickness, curve.unit = "texels";
  EXPECT_EQ(place_words(curve), "");
  curve.held = {{"lights.sun.elevation_degrees", "degrees", 20}, {"lights.rim.position.x", "m", -1.5}};
  EXPECT_EQ(place_words(curve), ", at elevation 20 degrees, at position.x -1.5 m");
  curve.parameter = "lights.key.intensity", curve.unit = "";
  curve.held = {{"lights.rim.intensity", "", 2}};
  EXPECT_EQ(place_words(curve), ", at rim.intensity 2");
}

TEST(Answers, UnknownMetricsAreRefusedWithTheNearest) {
  try {
    parse_limit("sweep", "sim=0.98");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'ssim'"), std::string::npos) << error.what();
  }
  for (const char* bad : {"ssim", "ssim=", "ssim=x", "ratio=1"}) EXPECT_THROW(parse_limit("sweep", bad), Error) << bad;
  EXPECT_EQ(parse_limit("sweep", "truth.flip=0.1").value, 0.1);
}

TEST(Curves, TheWorstViewCountsAndRatiosAreAveragedGeometrically) {
  CellRow front = sweep_cell("vertex_normal", 0, 0.9, 0.25), side = sweep_cell("vertex_normal", 0, 0.8, 1);
  side.view = "side";
  CellRow far_front = sweep_cell("vertex_normal", 1, 0.9, 0.5), far_side = far_front;
  far_side.view = "side";
  const auto curves = curves_of(sweep_record({0, 1}, {front, side, far_front, far_side}));
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_EQ(curves[0].x, (std::vector<double>{0, 1}));
  EXPECT_DOUBLE_EQ(curves[0].y.at("ssim")[0], 0.8);
  EXPECT_DOUBLE_EQ(curves[0].y.at("ratio")[0], 0.5);
  EXPECT_DOUBLE_EQ(curves[0].y.at("ratio")[1], 0.5);
}

}  // namespace
}  // namespace lamina
