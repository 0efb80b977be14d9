// SPDX-License-Identifier: Apache-2.0
// Points that a grid and a file give, what values at them are judged by, and what a slice is made of.
#include <cmath>
#include <limits>

#include "harness/core/error.h"
#include "harness/stress/pictures.h"
#include "harness/stress/point_sets.h"
#include "tests/stress/family_folder.h"

namespace lamina {
namespace {

class StressPoints : public FamilyFolder {
 protected:
  StressPoints() {
    family_.name = "sums";
    family_.value = "total";
    family_.oracle = &two_;
    family_.inputs = {{.name = "x0", .from = 0, .to = 2, .from_words = "0", .to_words = "2"},
                      {.name = "x1", .from = -1, .to = 1, .from_words = "-1", .to_words = "1"}};
    family_.sets = {{"rest", "shifted"}, {"steps", "counted"}};
  }
  std::vector<float> numbers(const PointSet& set) { return {set.points.numbers().begin(), set.points.numbers().end()}; }
  void refused(const std::string& text, const std::string& subject, const std::string& words) {
    const std::filesystem::path file = write("points.csv", text);
    try {
      read_points(family_, file);
      ADD_FAILURE() << "accepted: " << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      EXPECT_EQ(error.subject(), file.string() + subject);
      EXPECT_EQ(error.message(), words);
    }
  }
  WeightedSum two_{2};
  Family family_;
};

TEST_F(StressPoints, SetsComeInTheFamilysOrderFromTheOracle) {
  const std::vector<PointSet> sets = make_sets(family_, 4, 2);
  ASSERT_EQ(sets.size(), 2u);
  EXPECT_EQ(sets[0].name, "rest");
  EXPECT_EQ(sets[0].what, "shifted");
  EXPECT_EQ(sets[1].points.size(), 4u);
  EXPECT_EQ(sets[1].points[3][0], 5 * 0x1p-10f) << "the fourth, from seed 2 on";
  EXPECT_EQ(sets[1].points[3][1], 5 * 0x1p-11f);
}

TEST_F(StressPoints, AGridHasItsEndsAndItsLastInputRunsFastest) {
  EXPECT_EQ(numbers(make_grid(family_, 3)), (std::vector<float>{0, -1, 0, 0, 0, 1, 1, -1, 1, 0, 1, 1, 2, -1, 2, 0, 2, 1}));
  EXPECT_EQ(make_grid(family_, 3).what, "3 x 3 x0 in [0, 2], x1 in [-1, 1]");
  family_.grid = "sums";
  EXPECT_EQ(make_grid(family_, 3).what, "3 x 3 sums");
}

TEST_F(StressPoints, OpenEndsAreNoPartOfAGrid) {
  family_.inputs[0].low_open = family_.inputs[0].high_open = true;  // 0.5 1 1.5
  family_.inputs[1].low_open = true;                                // -1/3 1/3 1
  const PointSet set = make_grid(family_, 3);
  EXPECT_EQ(set.what, "3 x 3 x0 in (0, 2), x1 in (-1, 1]");
  EXPECT_EQ(numbers(set), (std::vector<float>{0.5f, -1 / 3.0f, 0.5f, 1 / 3.0f, 0.5f, 1, 1, -1 / 3.0f, 1, 1 / 3.0f, 1, 1, 1.5f,
                                              -1 / 3.0f, 1.5f, 1 / 3.0f, 1.5f, 1}));
  family_.inputs[0] = {.name = "x0", .from = 0, .to = 2, .high_open = true};
  EXPECT_EQ(make_grid(family_, 4).points[15][0], 1.5f);
}

// pi is no binary32 number; the one next to it is above it.
TEST_F(StressPoints, AGridsNumbersLieInTheRangeInBinary32Too) {
  family_.inputs[1].from = -3.141592653589793;
  family_.inputs[0].from = 1;
  family_.inputs[0].to = 2.7182817;  // its binary32 is above it too
  const PointSet set = make_grid(family_, 2);
  EXPECT_EQ(set.points[0][1], -3.14159250f);
  EXPECT_LE(set.points[3][0], 2.7182817);
  EXPECT_GT(set.points[3][0], 2.718281);
}

TEST_F(StressPoints, WhatTheOracleRefusesIsNotInAGrid) {
  family_.inputs[0].to = 6;  // 0 2 4 6, of which two are above 3
  const PointSet set = make_grid(family_, 4);
  EXPECT_EQ(set.points.size(), 8u);
  family_.inputs[0].from = 4;
  EXPECT_THROW(make_grid(family_, 4), Error);
}

TEST_F(StressPoints, BadGrids) {
  for (const size_t steps : {size_t{0}, size_t{1}, size_t{2024}, std::numeric_limits<size_t>::max()}) try {
      make_grid(family_, steps);
      ADD_FAILURE() << steps;
    } catch (const Error& error) {
      EXPECT_EQ(error.subject(), "--grid " + std::to_string(steps));
    }
}

TEST_F(StressPoints, AFileBringsInputsAndRightValues) {
  const PointSet set = read_points(
      family_, write("points.csv", "# by hand\nx0,x1,total\n\n1,0.5,2.5,a remark\r\n0.25,0.5\n0.1,1,2.1\n 1 , 1 , 7 \n"));
  EXPECT_EQ(set.name, "points");
  EXPECT_EQ(set.what, "points.csv");
  EXPECT_EQ(numbers(set), (std::vector<float>{1, 0.5f, 0.25f, 0.5f, 0.1f, 1, 1, 1}));
  ASSERT_EQ(set.given.size(), 4u);
  EXPECT_EQ(set.given[0], 2.5);
  EXPECT_TRUE(std::isnan(set.given[1])) << "none is given";
  EXPECT_TRUE(std::isnan(set.given[2])) << "0.1 is no binary32 number: the value is another input's";
  const PointTruth truth = truth_of(two_, set);
  EXPECT_EQ(truth.values[1], 1.25);
  EXPECT_EQ(truth.values[3], 7) << "what the file says, not the oracle's 3";
}

TEST_F(StressPoints, BadFiles) {
  refused("x0,x1\n1\n", ":2", "needs x0,x1 and may have total, separated by commas");
  refused("1,abc\n", ":1", "'abc' is not a finite number");
  refused("1,2x\n", ":1", "'2x' is not a finite number");
  refused("x01,1\n", ":1", "'x01' is not a finite number");
  refused("1,1\n1,inf\n", ":2", "'inf' is not a finite number");
  refused("1,1,nan\n", ":1", "'nan' is not a finite number");
  refused("1,1\n\n4,1\n", ":3", "no input may be above 3");
  refused("# none\nx0,x1\n", "", "holds no points; give lines of x0,x1");
  EXPECT_THROW(read_points(family_, folder_ / "absent.csv"), Error);
}

// The scale of WeightedSum is 2.
TEST_F(StressPoints, ErrorsAreOfTheScale) {
  const PointSet set{"", "", Points(2, {{1, 1}, {1, 0.5f}, {-1, 0}, {0.5f, 1}})};
  const FunctionErrors errors = judge(set.points, std::vector<float>{4, 1, -1, 2.5f}, truth_of(two_, set));
  EXPECT_EQ(errors.max_over, 0.5) << "4 for 3";
  EXPECT_EQ(errors.max_under, -0.5) << "1 for 2";
  EXPECT_EQ(errors.worst_over, (std::vector<double>{1, 1}));
  EXPECT_EQ(errors.worst_under, (std::vector<double>{1, 0.5}));
  EXPECT_EQ(errors.mean_absolute, 0.25);
  EXPECT_EQ(errors.rms, std::sqrt(0.125));
  EXPECT_EQ(errors.max_eps, 0x1p22);
  EXPECT_EQ(errors.max_eps_kappa, 0x1p22) << "half of 2, in units of 2^-23 and a condition number of 1";
  EXPECT_EQ(errors.negative + errors.nonfinite + errors.not_zero, 0u) << "-1 is right where it stands";
  EXPECT_FALSE(errors.first_fault);
}

// One third of the value, and half of the scale.
TEST_F(StressPoints, WhatConditionExcusesIsOfTheValue) {
  const PointSet set{"", "", Points(2, {{1, 1}})};
  const FunctionErrors errors = judge(set.points, std::vector<float>{4}, truth_of(two_, set));
  EXPECT_EQ(errors.max_eps, 0x1p22);
  EXPECT_DOUBLE_EQ(errors.max_eps_kappa, 0x1p23 / 3);
}

TEST_F(StressPoints, FaultsAreCountedAndTheFirstIsNamed) {
  const float nan = std::nanf("");
  const PointSet set{"", "", Points(2, {{1, 1}, {1, 0}, {0, 0}, {-1, 0}, {-2, 0}})};
  const FunctionErrors errors = judge(set.points, std::vector<float>{3, -1, 0.5f, nan, -1}, truth_of(two_, set));
  EXPECT_EQ(errors.negative, 1u) << "where 1 is right, not where -2 is";
  EXPECT_EQ(errors.not_zero, 1u);
  EXPECT_EQ(errors.nonfinite, 1u);
  EXPECT_EQ(*errors.first_fault, (std::vector<double>{1, 0}));
  EXPECT_EQ(errors.mean_absolute, (1 + 0.25 + 0.5) / 4) << "over those that are finite";
  const FunctionErrors none = judge(set.points, std::vector<float>(5, nan), truth_of(two_, set));
  EXPECT_EQ(none.nonfinite, 5u);
  EXPECT_EQ(none.max_over, 0);
  EXPECT_EQ(none.worst_over.size(), 2u);
}

TEST_F(StressPoints, WhatTheOracleRefusesHasNoTruth) {
  const PointTruth truth = truth_of(two_, {"", "", Points(2, {{1, 1}, {4, 1}})});
  EXPECT_EQ(truth.values[0], 3);
  EXPECT_TRUE(std::isnan(truth.values[1]) && std::isnan(truth.conditions[1]) && std::isnan(truth.scales[1]));
}

TEST_F(StressPoints, ASlicesPixelsAreTheMiddlesOfItsRanges) {
  WeightedSum four(4);
  family_.oracle = &four;
  family_.inputs.push_back({.name = "x2", .from = 0, .to = 1});
  family_.inputs.push_back({.name = "x3", .from = 0, .to = 1});
  family_.slices = {{.right = 1, .up = 0, .at = {0, 0, 0.5f, 0.1f}, .full_error = 0.25}};
  const std::vector<Slice> slices = make_slices(family_);
  ASSERT_EQ(slices.size(), 1u);
  EXPECT_EQ(slices[0].name, "x2 = 0.5, x3 = 0.1");
  EXPECT_EQ(slices[0].file, "-x2-0.5-x3-0.1.png");
  EXPECT_EQ(slices[0].axes, "x1 from -1 to 1 to the right, x0 from 0 to 2 upwards");
  EXPECT_EQ(slices[0].full_error, 0.25);
  const Points& points = slices[0].points;
  ASSERT_EQ(points.size(), 256u * 256);
  const auto is = [](std::span<const float> point) { return std::vector<float>(point.begin(), point.end()); };
  EXPECT_EQ(is(points[0]), (std::vector<float>{2 - 1 / 256.0f, -1 + 1 / 256.0f, 0.5f, 0.1f})) << "on top, to the left";
  EXPECT_EQ(is(points[1])[1], -1 + 3 / 256.0f);
  EXPECT_EQ(is(points[256])[0], 2 - 3 / 256.0f);
  EXPECT_EQ(slices[0].truth.values[0], four.value(std::vector<double>(points[0].begin(), points[0].end())));
}

}  // namespace
}  // namespace lamina
