// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "harness/core/error.h"
#include "harness/quality/quality.h"

namespace lamina {
namespace {

TEST(WorstTile, HasTheGreatestMean) {
  std::vector<float> map(64 * 64, 0.1f);
  for (int y = 32; y < 64; ++y)
    for (int x = 0; x < 32; ++x) map[y * 64 + x] = 0.5f;
  map[5] = 1;  // one bad pixel is not the worst tile
  const WorstTile worst = worst_tile(map, 64, 64);
  EXPECT_EQ(worst.x, 0);
  EXPECT_EQ(worst.y, 32);
  EXPECT_FLOAT_EQ(static_cast<float>(worst.flip), 0.5f);
}

TEST(WorstTile, AtAnEdgeItIsCutAndItsMeanIsOfWhatIsThere) {
  std::vector<float> map(40 * 33, 0.0f);
  map[32 * 40 + 39] = 0.8f;  // in the corner's tile of 8 x 1 pixels
  const WorstTile worst = worst_tile(map, 40, 33);
  EXPECT_EQ(worst.x, 32);
  EXPECT_EQ(worst.y, 32);
  EXPECT_NEAR(worst.flip, 0.1, 1e-6);
}

TEST(WorstTile, OfEqualTilesTheFirstByRows) {
  const WorstTile worst = worst_tile(std::vector<float>(64 * 64, 0.0f), 64, 64);
  EXPECT_EQ(worst.x, 0);
  EXPECT_EQ(worst.y, 0);
}

TEST(WorstTile, RefusesAMapOfAnotherSize) {
  EXPECT_THROW(worst_tile(std::vector<float>(10), 4, 4), Error);
  EXPECT_THROW(worst_tile({}, 0, 0), Error);
}

}  // namespace
}  // namespace lamina
