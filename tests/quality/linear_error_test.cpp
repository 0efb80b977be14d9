// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>

#include "tests/quality/pictures.h"

namespace lamina {
namespace {

TEST(LinearError, FollowsItsDefinitions) {
  // All differ by 0.25: the root mean square and the maximum are 0.25.
  EXPECT_EQ(rmse_linear(flat_linear(5, 3, 0.5f), flat_linear(5, 3, 0.25f)), 0.25);
  EXPECT_EQ(max_linear(flat_linear(5, 3, 0.5f), flat_linear(5, 3, 0.25f)), 0.25);
  // One of 2 * 3 channels differs by 3, another by -6: sqrt((9 + 36) / 6), and 6. Alpha counts in neither.
  const Image a{2, 1, {4, 0, 0, 9, 0, 0, -6, 9}}, b{2, 1, {1, 0, 0, 0, 0, 0, 0, 0}};
  EXPECT_DOUBLE_EQ(rmse_linear(a, b), std::sqrt(7.5));
  EXPECT_EQ(max_linear(a, b), 6);
}

TEST(LinearError, IsZeroForEqualPicturesAndSymmetric) {
  const Image a{2, 1, {4, 1, 2, 1, 0, 0, -6, 1}}, b{2, 1, {1, 0, 0, 1, 0, 7, 0, 1}};
  EXPECT_EQ(rmse_linear(a, a), 0);
  EXPECT_EQ(max_linear(a, a), 0);
  EXPECT_EQ(rmse_linear(a, b), rmse_linear(b, a));
  EXPECT_EQ(max_linear(a, b), max_linear(b, a));
}

TEST(LinearError, IsNotClampedAndDoesNotOverflow) {
  EXPECT_EQ(max_linear(flat_linear(2, 2, 1000), flat_linear(2, 2, 0)), 1000);
  EXPECT_DOUBLE_EQ(rmse_linear(flat_linear(2, 2, 3e38f), flat_linear(2, 2, -3e38f)), 2 * double{3e38f});
}

TEST(LinearError, CountsOnlyTheMask) {
  const Image zero = flat_linear(4, 1, 0);
  Image one = zero;
  one.rgba[4] = one.rgba[5] = one.rgba[6] = 2;
  const Mask all = whole(4, 1), half{4, 1, {1, 1, 0, 0}}, without{4, 1, {1, 0, 1, 1}};
  EXPECT_EQ(rmse_linear(one, zero, &all), rmse_linear(one, zero));
  EXPECT_EQ(max_linear(one, zero, &all), max_linear(one, zero));
  EXPECT_DOUBLE_EQ(rmse_linear(one, zero, &half), std::sqrt(2.0));
  EXPECT_EQ(rmse_linear(one, zero, &without), 0);
  EXPECT_EQ(max_linear(one, zero, &without), 0);
}

TEST(LinearError, RefusesACountedPixelThatIsNotFinite) {
  const Image good = flat_linear(2, 2, 1);
  const Mask without{2, 2, {1, 1, 0, 1}};
  for (const float value : {nan, inf, -inf})
    for (const size_t channel : {0, 1, 2, 3}) {
      Image bad = good;
      bad.rgba[4 * 2 + channel] = value;
      EXPECT_NE(refusal([&] { rmse_linear(bad, good); }).find("of the test picture are not finite"), std::string::npos);
      EXPECT_NE(refusal([&] { max_linear(good, bad); }).find("of the reference picture are not finite"), std::string::npos);
      EXPECT_EQ(rmse_linear(bad, good, &without), 0);
      EXPECT_EQ(nonfinite_pixels(bad), 1);
    }
}

TEST(LinearError, RefusesWhatHasNoFigure) {
  const Image a = flat_linear(4, 3, 1), b = flat_linear(3, 4, 1), short_one{4, 3, std::vector<float>(5)};
  const Mask none{4, 3, std::vector<uint8_t>(12)}, other = whole(3, 4), short_mask{4, 3, {1, 1}};
  for (const auto figure : {rmse_linear, max_linear}) {
    EXPECT_NE(refusal([&] { figure(a, b, nullptr); }).find("test is 4 x 3 pixels, reference 3 x 4"), std::string::npos);
    EXPECT_NE(refusal([&] { figure({}, {}, nullptr); }).find("empty"), std::string::npos);
    EXPECT_NE(refusal([&] { figure(short_one, a, nullptr); }).find("5 values where 48"), std::string::npos);
    EXPECT_NE(refusal([&] { figure(a, a, &none); }).find("no pixel is counted"), std::string::npos);
    EXPECT_NE(refusal([&] { figure(a, a, &other); }).find("the mask is 3 x 4"), std::string::npos);
    EXPECT_NE(refusal([&] { figure(a, a, &short_mask); }).find("the mask holds 2 pixels"), std::string::npos);
  }
}

TEST(RangeLinear, IsOfTheColourChannelWithTheMostOverCountedPixels) {
  Image picture{3, 1, {0.1f, 0.2f, 0.4f, 0, 0.1f, 0.2f, 0.4f, 1, 0.2f, 0.8f, 0.3f, 1}};  // a colour that is no grey, twice
  EXPECT_NEAR(range_linear(picture), 0.6, 1e-6);
  const Mask two{3, 1, {1, 1, 0}}, none{3, 1, {0, 0, 0}};
  EXPECT_EQ(range_linear(picture, &two), 0);
  EXPECT_NE(refusal([&] { range_linear(picture, &none); }).find("no pixel is counted"), std::string::npos);
  EXPECT_NE(refusal([] { range_linear({}); }).find("empty"), std::string::npos);
  picture.rgba[8] = nan;
  EXPECT_EQ(range_linear(picture, &two), 0) << "what is not counted does not count";
  EXPECT_NE(refusal([&] { range_linear(picture); }).find("not finite"), std::string::npos);
}

TEST(NonfinitePixels, CountsPixelsNotValues) {
  EXPECT_EQ(nonfinite_pixels(flat_linear(5, 5, std::numeric_limits<float>::max())), 0);
  EXPECT_EQ(nonfinite_pixels({3, 1, {nan, nan, nan, nan, 1, 1, 1, 1, 1, 1, 1, inf}}), 2);
  EXPECT_NE(refusal([] { nonfinite_pixels({}); }).find("empty"), std::string::npos);
}

TEST(MaxAlpha, IsOfAlphaAloneWhereTheMaskCounts) {
  const Image reference{2, 1, {0.1f, 0.2f, 0.3f, 1, 0.1f, 0.2f, 0.3f, 0.5f}};
  Image test = reference;
  test.rgba[0] = 7, test.rgba[3] = 0.75f, test.rgba[7] = 0;
  EXPECT_DOUBLE_EQ(max_alpha(test, reference), 0.5);
  const Mask first{2, 1, {1, 0}};
  EXPECT_DOUBLE_EQ(max_alpha(test, reference, &first), 0.25);
  test.rgba[7] = NAN;
  EXPECT_THROW(max_alpha(test, reference), Error);
}

}  // namespace
}  // namespace lamina
