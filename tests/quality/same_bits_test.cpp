// SPDX-License-Identifier: Apache-2.0
#include "harness/quality/same_bits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "harness/core/error.h"

namespace lamina {
namespace {

Image half_grey(int width, int height) {
  Image image{width, height, {}};
  image.rgba.assign(static_cast<size_t>(width * height * 4), 0.5f);
  return image;
}

TEST(BitDifference, CountsPixelsAndFindsTheLargest) {
  const Image a = half_grey(3, 2);
  EXPECT_EQ(bit_difference(a, a).pixels, 0u);
  Image b = a;
  b.rgba[3] = 0;  // alpha of the first pixel
  EXPECT_EQ(bit_difference(a, b).pixels, 0u) << "alpha does not count";
  b.rgba[4 * 1 + 2] = std::nextafter(0.5f, 1.0f);
  b.rgba[4 * 5 + 0] = 0.75f;
  const BitDifference difference = bit_difference(a, b);
  EXPECT_EQ(difference.pixels, 2u) << "one unit in the last place counts";
  EXPECT_EQ(difference.largest, 0.25);
  EXPECT_EQ(difference.x, 2);
  EXPECT_EQ(difference.y, 1);
  EXPECT_EQ(bit_difference(b, a).largest, 0.25);
}

TEST(BitDifference, WhatIsNotFiniteIsEqualToItselfAlone) {
  const Image a = half_grey(2, 1);
  Image nan = a;
  nan.rgba[0] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(bit_difference(nan, nan).pixels, 0u);
  EXPECT_EQ(bit_difference(a, nan).pixels, 1u);
  EXPECT_EQ(bit_difference(a, nan).largest, 1e30);
  EXPECT_THROW(bit_difference(a, half_grey(1, 2)), Error);
}

}  // namespace
}  // namespace lamina
