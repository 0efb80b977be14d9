// SPDX-License-Identifier: Apache-2.0
// The references: the 400-bit oracle against closed forms and tabulated values, and the double form against the oracle.
#include "harness/effects/cap_intersection/cap_area.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "harness/core/error.h"
#include "harness/effects/cap_intersection/cap_oracle.h"
#include "harness/effects/cap_intersection/cap_sets.h"
#include "tests/effects/caps.h"

namespace lamina {
namespace {

using std::numbers::pi;
constexpr double eps = 0x1p-52;

TEST(CapOracle, TwoHemispheresShareALune) {
  for (const double d : {0.1, 1.0, 2.0, 3.0}) EXPECT_NEAR(cap_intersection_oracle(pi / 2, pi / 2, d), 2 * (pi - d), 1e-15 * 7);
}

TEST(CapOracle, ApartContainedAndCovering) {
  EXPECT_EQ(cap_intersection_oracle(0.5, 0.25, 0.75), 0);
  EXPECT_EQ(cap_intersection_oracle(0.5, 0.25, 2), 0);
  EXPECT_NEAR(cap_intersection_oracle(1, 0.5, 0.25), 2 * pi * (1 - std::cos(0.5)), 1e-15);
  EXPECT_NEAR(cap_intersection_oracle(2, 2.5, 3), -2 * pi * (std::cos(2) + std::cos(2.5)), 1e-14);
}

// The caps and their complements share out the sphere: both, one only, the other only, neither.
TEST(CapOracle, ComplementsAddUpToTheSphere) {
  for (const auto& [r0, r1, d] : {std::tuple{1.0, 0.8, 1.2}, {2.0, 0.7, 1.6}, {1.4, 1.5, 0.3}}) {
    const double both = cap_intersection_oracle(r0, r1, d), first = cap_intersection_oracle(r0, pi - r1, pi - d),
                 second = cap_intersection_oracle(pi - r0, r1, pi - d), neither = cap_intersection_oracle(pi - r0, pi - r1, d);
    EXPECT_NEAR(both + first + second + neither, 4 * pi, 1e-13);
    EXPECT_NEAR(both + first, 2 * pi * (1 - std::cos(r0)), 1e-14) << "the second cap and its complement cut the first in two";
  }
}

// Caps so small that the sphere is flat: the lens of two circles in the plane (equal radii, one radius apart).
TEST(CapOracle, TinyCapsAreFlat) {
  const double r = 1e-6, lens = r * r * (2 * pi / 3 - std::sqrt(3.0) / 2);
  EXPECT_NEAR(cap_intersection_oracle(r, r, r) / lens, 1, 1e-11);
}

TEST(CapOracle, RefusesWhatIsNoCap) {
  for (const double r : {0.0, -1.0, 3.1416, 4.0, std::nan("")}) EXPECT_THROW(cap_intersection_oracle(r, 1, 1), Error) << r;
  EXPECT_THROW(cap_intersection_oracle(1, 1, -0.1), Error);
  EXPECT_THROW(cap_intersection_oracle(1, 1, 3.2), Error);
}

TEST(CapOracle, AgreesWithTabulatedValues) {
  const std::filesystem::path file = std::filesystem::path(LAMINA_DATA_DIR) / "spherical_cap_intersection.csv";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is absent: reference values are not part of the product";
  const PointSet set = read_points(caps(), file);
  size_t compared = 0;
  for (size_t i = 0; i < set.points.size(); ++i) {
    if (std::isnan(set.given[i])) continue;
    const double r0 = set.points[i][0], r1 = set.points[i][1], d = set.points[i][2];
    EXPECT_NEAR(cap_intersection_oracle(r0, r1, d), set.given[i], eps * set.given[i]) << r0 << " " << r1 << " " << d;
    ++compared;
  }
  EXPECT_GT(compared, 20u);
}

class CapArea : public ::testing::TestWithParam<std::string> {};

TEST_P(CapArea, DoubleFormIsWithinItsBoundOfTheOracle) {
  const Points points = make_cap_points(GetParam(), 400, 11);
  for (size_t i = 0; i < points.size(); ++i) {
    const double r0 = points[i][0], r1 = points[i][1], d = points[i][2];
    const double truth = cap_intersection_oracle(r0, r1, d), area = cap_intersection_area(r0, r1, d);
    ASSERT_LE(std::abs(area - truth), 4 * eps * std::max(1.0, cap_intersection_condition(r0, r1, d, area)) * truth)
        << r0 << " " << r1 << " " << d << ": " << area << " for " << truth;
  }
}

INSTANTIATE_TEST_SUITE_P(Sets, CapArea, ::testing::ValuesIn(cap_set_names()), [](const auto& test) { return test.param; });

// d area / d d = -2 sin r0 sin A, so the area falls with the distance, by no more than 2 min(sin r0, sin r1) a radian.
TEST(CapAreaProperty, FallsWithDistanceNoFasterThanItsBound) {
  for (const PointSet& set : make_sets(caps(), 300, 3))
    for (size_t i = 0; i < set.points.size(); ++i) {
      const double r0 = set.points[i][0], r1 = set.points[i][1], d = set.points[i][2];
      const double step = (pi - d) * 1e-3, here = cap_intersection_area(r0, r1, d),
                   there = cap_intersection_area(r0, r1, d + step);
      const double noise = 64 * eps * smaller_cap_area(r0, r1);
      ASSERT_LE(there, here + noise) << set.name << " " << r0 << " " << r1 << " " << d;
      ASSERT_LE(here - there, 2 * step * std::min(std::sin(r0), std::sin(r1)) * (1 + 1e-2) + noise)
          << set.name << " " << r0 << " " << r1 << " " << d;
    }
}

}  // namespace
}  // namespace lamina
