// SPDX-License-Identifier: Apache-2.0
#include "harness/scene/made/marble.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lamina {
namespace {

// Mean distance between neighbours along an axis within the picture, and across its border.
struct Steps {
  double inside = 0, across = 0;
};
Steps steps(const Texels& texels, bool along_u) {
  const uint32_t length = along_u ? texels.width : texels.height, lines = along_u ? texels.height : texels.width;
  const auto at = [&](uint32_t i, uint32_t line) {
    return texels.rgba[along_u ? size_t{line} * texels.width + i : size_t{i} * texels.width + line];
  };
  Steps mean;
  for (uint32_t line = 0; line < lines; ++line) {
    for (uint32_t i = 0; i + 1 < length; ++i)
      mean.inside += glm::distance(at(i, line), at(i + 1, line)) / double(lines * (length - 1));
    mean.across += glm::distance(at(length - 1, line), at(0, line)) / double(lines);
  }
  return mean;
}

TEST(Marble, TilesWithoutASeam) {
  const Texels texels = marble(128, 96, 1);
  for (const bool along_u : {true, false}) {
    const Steps mean = steps(texels, along_u);
    EXPECT_LT(mean.across, 1.5 * mean.inside) << "the border is a step like any other";
    EXPECT_GT(mean.across, 0.0);
  }
}

TEST(Marble, IsRepeatableAndVaried) {
  const Texels a = marble(64, 64, 1), b = marble(64, 64, 1), other = marble(64, 64, 2);
  EXPECT_EQ(a.rgba, b.rgba);
  EXPECT_NE(a.rgba, other.rgba);
  glm::vec4 low(1), high(0);
  for (const glm::vec4 texel : a.rgba) low = glm::min(low, texel), high = glm::max(high, texel);
  EXPECT_TRUE(glm::all(glm::greaterThanEqual(low, glm::vec4(0)))) << "a colour";
  EXPECT_TRUE(glm::all(glm::lessThanEqual(high, glm::vec4(1)))) << "an albedo";
  EXPECT_EQ(low.a, 1.0f);
  EXPECT_GT(high.r - low.r, 0.4f) << "parallax shows only where a picture varies";
}

}  // namespace
}  // namespace lamina
