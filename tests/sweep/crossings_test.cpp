// SPDX-License-Identifier: Apache-2.0
// Curves whose crossings are known in closed form.
#include "harness/sweep/crossings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace lamina {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();

std::vector<Crossing> crossings_of(const std::function<double(double)>& curve, double from, double to, double step,
                                   double limit) {
  std::vector<double> x, y;
  for (double at = from; at <= to + step / 2; at += step) x.push_back(at), y.push_back(curve(at));
  return crossings(x, y, limit);
}

TEST(Crossings, AStraightLineIsMetExactly) {
  const auto found = crossings_of([](double x) { return 1 - x / 10; }, 0, 10, 1, 0.35);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].at, 6.5, 1e-12);
  EXPECT_NEAR(found[0].tolerance, 0, 1e-9);
  EXPECT_FALSE(found[0].rising);
}

// Convex and concave, falling and rising: the stated tolerance holds, and is far below the step.
TEST(Crossings, BendingCurvesKeepTheirTolerance) {
  const struct {
    std::function<double(double)> curve;
    std::function<double(double)> inverse;
  } cases[] = {{[](double x) { return 1 - x * x / 100; }, [](double y) { return 10 * std::sqrt(1 - y); }},
               {[](double x) { return std::exp(-x / 5); }, [](double y) { return -5 * std::log(y); }},
               {[](double x) { return std::sqrt(x / 10); }, [](double y) { return 10 * y * y; }},
               {[](double x) { return x * x / 100; }, [](double y) { return 10 * std::sqrt(y); }}};
  for (const auto& [curve, inverse] : cases)
    for (double limit = 0.2; limit < 0.85; limit += 0.01) {
      const auto found = crossings_of(curve, 0, 10, 0.5, limit);
      ASSERT_EQ(found.size(), 1u) << limit;
      EXPECT_LE(std::abs(found[0].at - inverse(limit)), found[0].tolerance + 1e-9) << limit;
      if (inverse(limit) > 1 && inverse(limit) < 9) {
        EXPECT_LT(found[0].tolerance, 0.1) << limit;
      }
    }
}

TEST(Crossings, AWaveCrossesEachTimeWithinItsTolerance) {
  const auto found = crossings_of([](double x) { return std::sin(x); }, 0.25, 9, 0.5, 0);
  ASSERT_EQ(found.size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    EXPECT_LE(std::abs(found[i].at - M_PI * double(i + 1)), found[i].tolerance);
    EXPECT_EQ(found[i].rising, i == 1);
  }
}

TEST(Crossings, WhereSamplesBendBothWaysTheBracketIsTheTolerance) {
  const std::vector<double> x = {0, 1, 2, 3}, y = {0, 3, -3, 0};  // a zigzag
  const auto found = crossings(x, y, 0);
  ASSERT_EQ(found.size(), 2u);  // at the last sample it is at the limit again
  EXPECT_DOUBLE_EQ(found[0].at, 1.5);
  EXPECT_DOUBLE_EQ(found[0].tolerance, 0.5);
}

TEST(Crossings, MeetingTheLimitIsWithinIt) {
  const std::vector<double> x = {0, 1, 2}, y = {1, 1, 0};
  const auto found = crossings(x, y, 1);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_DOUBLE_EQ(found[0].at, 1);
}

TEST(Crossings, NothingIsToldBesideASampleThatIsNotKnown) {
  const std::vector<double> x = {0, 1, 2, 3};
  EXPECT_TRUE(crossings(x, std::vector<double>{1, nan, 0, 0}, 0.5).empty());
  EXPECT_EQ(crossings(x, std::vector<double>{1, nan, 1, 0}, 0.5).size(), 1u);
}

TEST(Crossings, FromAnInfiniteSampleItIsHalfway) {
  const std::vector<double> x = {0, 1}, y = {infinity, 30};
  const auto found = crossings(x, y, 40);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_DOUBLE_EQ(found[0].at, 0.5);
  EXPECT_DOUBLE_EQ(found[0].tolerance, 0.5);
}

}  // namespace
}  // namespace lamina
