// SPDX-License-Identifier: Apache-2.0
// What is no picture, on frames of 16 x 16 pixels made by hand: the effect covers the right half.
#include "harness/quality/judged_picture.h"

#include <gtest/gtest.h>

#include <limits>

#include "harness/core/error.h"

namespace lamina {
namespace {

constexpr int side = 16;
const glm::vec3 sky(0.5f);

Image filled(glm::vec3 colour) {
  Image image{side, side, std::vector<float>(4 * side * side, 1.0f)};
  for (size_t pixel = 0; pixel < side * side; ++pixel)
    for (size_t c = 0; c < 3; ++c) image.rgba[4 * pixel + c] = colour[int(c)];
  return image;
}
Mask columns_from(int first) {
  Mask mask{side, side, std::vector<uint8_t>(side * side, 0)};
  for (int i = 0; i < side * side; ++i) mask.on[size_t(i)] = i % side >= first;
  return mask;
}
// Sky, and from column `first` on a ramp of greys.
Image ramp_from(int first) {
  Image image = filled(sky);
  for (int i = 0; i < side * side; ++i)
    if (i % side >= first)
      for (size_t c = 0; c < 3; ++c) image.rgba[size_t(4 * i) + c] = 0.05f * float(i / side);
  return image;
}

class JudgedPicture : public testing::Test {
 protected:
  std::string why(const Image& picture, const Mask& covered) {
    return why_no_picture({picture, covered}, {ramp_, right_}, sky);
  }
  const Image ramp_ = ramp_from(8);
  const Mask right_ = columns_from(8);
};

TEST_F(JudgedPicture, TheBaselineItselfAndWhatIsNearItArePictures) {
  EXPECT_EQ(why(ramp_, right_), "");
  Image darker = ramp_;
  for (float& value : darker.rgba) value *= 0.1f;
  EXPECT_EQ(why(darker, right_), "");
  EXPECT_EQ(why_not_finite(ramp_), "");
}

TEST_F(JudgedPicture, PixelsThatAreNotFiniteAreCountedAndTheFirstIsNamed) {
  Image bad = ramp_;
  for (const size_t pixel : {3u * side + 5u, 9u * side + 1u}) bad.rgba[4 * pixel + 1] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(why_not_finite(bad), "2 of 256 pixels are not finite numbers, the first at (5, 3)");
  bad = ramp_;
  bad.rgba[3] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(why_not_finite(bad), "1 of 256 pixels is not a finite number, the first at (0, 0)");
}

TEST_F(JudgedPicture, NothingDrawnIsTheBackground) {
  EXPECT_EQ(why(filled(sky), right_), "nothing is drawn where the baseline covers 128 pixels");
  EXPECT_EQ(why(filled(sky), columns_from(side)), "nothing is drawn where the baseline covers 128 pixels");
}

TEST_F(JudgedPicture, OneColourIsNoPictureUnlessTheBaselineIsOneToo) {
  EXPECT_EQ(why(filled({0.2f, 0.2f, 0.2f}), right_), "it is one colour all over the 128 pixels that the baseline covers");
  const Image grey = filled({0.2f, 0.2f, 0.2f}), other = filled({0.3f, 0.3f, 0.3f});
  EXPECT_EQ(why_no_picture({other, right_}, {grey, right_}, sky), "");
}

TEST_F(JudgedPicture, DrawingOutsideIsAnErrorBeyondAFewPixels) {
  // Two more columns: 32 pixels, too few to say it of so small a picture; six: 96.
  EXPECT_EQ(why(ramp_from(6), columns_from(6)), "");
  const std::string words = why(ramp_from(2), columns_from(2));
  EXPECT_NE(words.find("where the baseline, which covers 128, covers nothing"), std::string::npos) << words;
  EXPECT_EQ(why(ramp_, columns_from(2)), "") << "what it shades there looks as in the baseline's frame";
  EXPECT_EQ(why(ramp_from(2), right_), "") << "another effect drew it";
}

TEST_F(JudgedPicture, AFewPixelsAreNotJudged) {
  EXPECT_EQ(why_no_picture({filled(sky), columns_from(13)}, {ramp_from(13), columns_from(13)}, sky), "") << "48 pixels";
}

TEST_F(JudgedPicture, SizesThatDifferAreRefused) {
  const Image small{1, 1, {0, 0, 0, 1}};
  EXPECT_THROW(why(small, right_), Error);
}

}  // namespace
}  // namespace lamina
