// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <opencv2/quality/qualitymse.hpp>

#include "tests/quality/pictures.h"

namespace lamina {
namespace {

TEST(Psnr, FollowsItsDefinitionWhereEveryChannelDiffersByKSteps) {
  for (const int k : {1, 5, 51, 255})
    EXPECT_DOUBLE_EQ(psnr_db(flat(7, 5, grey(k)), flat(7, 5, grey(0))), 20 * std::log10(255.0 / k)) << k;
}

TEST(Psnr, IsTheMeanOverTheThreeChannels) {
  // Only red differs, by 30: MSE is 900 / 3.
  EXPECT_DOUBLE_EQ(psnr_db(flat(4, 4, {130, 9, 9}), flat(4, 4, {100, 9, 9})), 10 * std::log10(255.0 * 255.0 / 300));
}

TEST(Psnr, IsExactOnLargeOppositePictures) {
  // 0 dB: 3 * 300 * 300 squares of 255 pass 2^32, where an integer sum would wrap.
  EXPECT_DOUBLE_EQ(psnr_db(flat(300, 300, grey(255)), flat(300, 300, grey(0))), 0);
}

TEST(Psnr, IsInfiniteForEqualPictures) {
  EXPECT_EQ(psnr_db(noise(9, 7, 1), noise(9, 7, 1)), std::numeric_limits<double>::infinity());
}

TEST(Psnr, IsSymmetric) { EXPECT_EQ(psnr_db(noise(9, 7, 1), noise(9, 7, 2)), psnr_db(noise(9, 7, 2), noise(9, 7, 1))); }

TEST(Psnr, AgreesWithOpenCvsQualityModule) {
  DisplayImage a = noise(33, 17, 1), b = noise(33, 17, 2);
  const cv::Scalar mse = cv::quality::QualityMSE::compute(cv::Mat(17, 33, CV_8UC3, b.rgb.data()),
                                                          cv::Mat(17, 33, CV_8UC3, a.rgb.data()), cv::noArray());
  EXPECT_NEAR(psnr_db(a, b), 10 * std::log10(255 * 255 * 3 / (mse[0] + mse[1] + mse[2])), 1e-9);
}

TEST(Psnr, CountsOnlyTheMask) {
  const DisplayImage black = flat(6, 4, grey(0));
  DisplayImage one_pixel = black;
  one_pixel.rgb[3 * 8] = one_pixel.rgb[3 * 8 + 1] = one_pixel.rgb[3 * 8 + 2] = 17;  // 255 / 15
  Mask mask = whole(6, 4);
  EXPECT_EQ(psnr_db(one_pixel, black, &mask), psnr_db(one_pixel, black));
  mask.on.assign(24, 0);
  mask.on[8] = mask.on[9] = 1;  // half of the counted squares are 17^2
  EXPECT_DOUBLE_EQ(psnr_db(one_pixel, black, &mask), 20 * std::log10(15.0) + 10 * std::log10(2.0));
  mask.on[8] = 0;
  EXPECT_EQ(psnr_db(one_pixel, black, &mask), std::numeric_limits<double>::infinity());
}

TEST(Psnr, RefusesWhatHasNoFigure) {
  const DisplayImage a = flat(4, 3, grey(1));
  const Mask none{4, 3, std::vector<uint8_t>(12)}, other = whole(3, 4);
  EXPECT_NE(refusal([&] { psnr_db(a, flat(3, 4, grey(1))); }).find("test is 4 x 3 pixels, reference 3 x 4"), std::string::npos);
  EXPECT_NE(refusal([&] { psnr_db({}, {}); }).find("empty"), std::string::npos);
  EXPECT_NE(refusal([&] { psnr_db(a, a, &none); }).find("no pixel is counted"), std::string::npos);
  EXPECT_NE(refusal([&] { psnr_db(a, a, &other); }).find("the mask is 3 x 4"), std::string::npos);
}

}  // namespace
}  // namespace lamina
