// SPDX-License-Identifier: Apache-2.0
// What truths read of a texture, beyond its borders.
#include "harness/truth/filtered_texture.h"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(FilteredTexture, WrapsAsTheTextureAsks) {
  Texels row{4, 1, {}};
  for (int i = 0; i < 4; ++i) row.rgba.emplace_back(float(i) / 4, 0, 0, 1);
  const auto at = [&](Wrap u, double place) {
    Texels asked = row;
    asked.wraps = {u, Wrap::repeat};
    const FilteredTexture texture(*make_texture("row", asked, TexelMeaning::data));
    return texture.base({place, 0.5}).x * 4;
  };
  constexpr double code = 4.0 / 255;
  // Texels' centres lie at 1/8, 3/8, 5/8, 7/8.
  EXPECT_NEAR(at(Wrap::repeat, 1.125), 0, code);
  EXPECT_NEAR(at(Wrap::mirror, 1.125), 3, code);
  EXPECT_NEAR(at(Wrap::clamp, 1.125), 3, code);
  EXPECT_NEAR(at(Wrap::mirror, 1.625), 1, code);
  EXPECT_NEAR(at(Wrap::clamp, 1.625), 3, code);
  EXPECT_NEAR(at(Wrap::mirror, -0.375), 1, code);
  EXPECT_NEAR(at(Wrap::clamp, -0.375), 0, code);
  EXPECT_NEAR(at(Wrap::mirror, 2.375), 1, code);
  // At the border linear filtering mixes the two that meet there.
  EXPECT_NEAR(at(Wrap::repeat, 1), 1.5, code);
  EXPECT_NEAR(at(Wrap::mirror, 1), 3, code);
  // Without a word of its own a texture is repeated.
  EXPECT_NEAR(FilteredTexture(*make_texture("row", row, TexelMeaning::data)).base({1.125, 0.5}).x * 4, 0, code);
}

}  // namespace
}  // namespace lamina
