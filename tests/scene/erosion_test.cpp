// SPDX-License-Identifier: Apache-2.0
// Eroded land: no slope that would slide, and water that reaches the outlet.
#include "harness/scene/made/erosion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace lamina {
namespace {

constexpr Erosion options{.side = 129, .extent_m = 3000, .relief_m = 900, .steepest = 0.8f, .seed = 3};

const Terrain& terrain() {
  static const Terrain made = eroded_valley(options);
  return made;
}

TEST(Erosion, FillsItsGrid) {
  EXPECT_EQ(terrain().side, 129u);
  EXPECT_FLOAT_EQ(terrain().spacing_m, 3000.0f / 128);
  EXPECT_EQ(terrain().height_m.size(), 129u * 129u);
  EXPECT_EQ(terrain().drained_m2.size(), 129u * 129u);
  const auto [low, high] = std::minmax_element(terrain().height_m.begin(), terrain().height_m.end());
  EXPECT_EQ(*low, 0.0f);
  EXPECT_LE(*high, 900.01f);
  EXPECT_GT(*high, 300.0f);
}

TEST(Erosion, NothingIsSteeperThanStoneCanStand) {
  float steepest = 0;
  for (uint32_t row = 0; row < 129; ++row)
    for (uint32_t column = 0; column < 129; ++column)
      for (const auto& [right, down] : {std::pair{1, 0}, {0, 1}, {1, 1}, {-1, 1}}) {
        const uint32_t x = column + uint32_t(right), y = row + uint32_t(down);
        if (x >= 129 || y >= 129) continue;
        const float run = terrain().spacing_m * (right && down ? std::sqrt(2.0f) : 1.0f);
        steepest = std::max(steepest, std::abs(terrain().at(x, y) - terrain().at(column, row)) / run);
      }
  EXPECT_LE(steepest, 0.8f * 1.001f);
  EXPECT_GT(steepest, 0.7f) << "it is mountains";
}

// The outlet lies in the middle tenth of the near edge, at height 0; what rains on the land comes out there.
TEST(Erosion, WaterReachesTheOutlet) {
  double out = 0;
  for (uint32_t column = 0; column < 129; ++column)
    if (terrain().at(column, 128) == 0) {
      EXPECT_NEAR(float(column), 64.0f, 7.0f);
      out += terrain().drained_m2[128 * 129 + column];
    }
  const double cell = terrain().spacing_m * terrain().spacing_m, all = cell * 129 * 129;
  EXPECT_GT(out, 0.9 * all);
  EXPECT_LE(out, 1.0001 * all);
  EXPECT_FLOAT_EQ(*std::min_element(terrain().drained_m2.begin(), terrain().drained_m2.end()), float(cell));
}

TEST(Erosion, IsTheSameEveryTimeAndAnotherBySeed) {
  EXPECT_EQ(eroded_valley(options).height_m, terrain().height_m);
  Erosion other = options;
  other.seed = 4;
  EXPECT_NE(eroded_valley(other).height_m, terrain().height_m);
}

}  // namespace
}  // namespace lamina
