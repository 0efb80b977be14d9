// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "harness/core/srgb.h"
#include "tests/quality/pictures.h"

namespace lamina {
namespace {

TEST(Srgb, HitsTheStandardsClosedFormPoints) {
  EXPECT_EQ(srgb_encode(0), 0);
  EXPECT_FLOAT_EQ(srgb_encode(1), 1);
  EXPECT_EQ(srgb_decode(0.f), 0);
  EXPECT_FLOAT_EQ(srgb_decode(1.f), 1);
  // The linear part, and the power part by its formula in double: ((0.5 + 0.055) / 1.055)^2.4 = 0.21404114.
  EXPECT_FLOAT_EQ(srgb_encode(0.002f), 0.02584f);
  EXPECT_FLOAT_EQ(srgb_decode(0.02584f), 0.002f);
  EXPECT_FLOAT_EQ(srgb_decode(0.5f), 0.21404114f);
  EXPECT_FLOAT_EQ(srgb_encode(0.21404114f), 0.5f);
  EXPECT_FLOAT_EQ(srgb_encode(0.5f), static_cast<float>(1.055 * std::pow(0.5, 1 / 2.4) - 0.055));
}

TEST(Srgb, JoinsItsTwoPartsAtTheThreshold) {
  // The standard's rounded constants leave a step of less than 1e-6 there.
  EXPECT_NEAR(srgb_encode(0.0031308f), srgb_encode(std::nextafter(0.0031308f, 1.f)), 1e-6);
  EXPECT_NEAR(srgb_decode(0.04045f), srgb_decode(std::nextafter(0.04045f, 1.f)), 1e-6);
}

TEST(ToDisplay, GivesBackEachOfThe256CodesFromItsLinearValue) {
  Image linear{256, 1, {}};
  for (int code = 0; code < 256; ++code) {
    const float value = srgb_decode(static_cast<float>(code) / 255);
    linear.rgba.insert(linear.rgba.end(), {value, value, value, 0.5f});
  }
  EXPECT_EQ(to_display(linear).rgb, painted(256, 1, [](int x, int) { return grey(x); }).rgb);
}

TEST(ToDisplay, RoundsToTheNearestCode) {
  // Just below and just above half-way between two codes of the encoded value.
  for (const int code : {0, 7, 100, 254}) {
    const float below = srgb_decode((static_cast<float>(code) + 0.499f) / 255);
    const float above = srgb_decode((static_cast<float>(code) + 0.501f) / 255);
    const std::vector<uint8_t> rgb = to_display({1, 1, {below, above, below, 1}}).rgb;
    EXPECT_EQ(rgb, (std::vector<uint8_t>{uint8_t(code), uint8_t(code + 1), uint8_t(code)}));
  }
}

// Codes are looked up: around each value at which one begins, and over [0,1], it is as many as have begun.
TEST(ToDisplay, IsTheNearestCodeOfEveryValue) {
  std::vector<float> begins;
  for (int code = 0; code < 255; ++code) begins.push_back(static_cast<float>(srgb_decode((code + 0.5) / 255)));
  Image linear{0, 1, {}};
  const auto add = [&](float value) { linear.rgba.insert(linear.rgba.end(), {value, value, value, 1}), ++linear.width; };
  for (const float begin : begins) {
    const auto bits = std::bit_cast<uint32_t>(begin);
    for (uint32_t near = bits - 40; near < bits + 40; ++near) add(std::bit_cast<float>(near));
    EXPECT_NEAR(255 * srgb_encode(begin), std::floor(255 * srgb_encode(begin)) + 0.5, 1e-4);
  }
  for (uint32_t bits = 0; bits <= std::bit_cast<uint32_t>(1.f); bits += 9973) add(std::bit_cast<float>(bits));
  for (const float value : {0.f, -0.f, std::numeric_limits<float>::denorm_min(), std::nextafter(1.f, 0.f), 1.f}) add(value);
  const DisplayImage shown = to_display(linear);
  for (size_t i = 0; i < shown.rgb.size() / 3; ++i)
    ASSERT_EQ(shown.rgb[3 * i], std::upper_bound(begins.begin(), begins.end(), linear.rgba[4 * i]) - begins.begin())
        << linear.rgba[4 * i];
}

TEST(ToDisplay, ClampsWhatADisplayCannotShowAndDropsAlpha) {
  EXPECT_EQ(to_display({2, 1, {-1, 2, inf, nan, -inf, 0.5f, 1, inf}}).rgb, (std::vector<uint8_t>{0, 255, 255, 0, 188, 255}));
}

TEST(ToDisplay, RefusesNan) {
  Image image = flat_linear(3, 2, 0.5f);
  image.rgba[4 * 5 + 1] = nan;
  const std::string message = refusal([&] { to_display(image); });
  EXPECT_NE(message.find("1 of 6 pixels"), std::string::npos) << message;
  EXPECT_NE(message.find("x 2, y 1"), std::string::npos) << message;
}

TEST(ToDisplay, RefusesAnEmptyAndAHalfFilledPicture) {
  EXPECT_NE(refusal([] { to_display({}); }).find("empty"), std::string::npos);
  EXPECT_NE(refusal([] { to_display({2, 2, std::vector<float>(12)}); }).find("12 values where 16"), std::string::npos);
}

}  // namespace
}  // namespace lamina
