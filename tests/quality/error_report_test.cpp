// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <limits>

#include "tests/quality/pictures.h"

namespace lamina {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

Image linear_noise(int width, int height, uint32_t seed) {
  std::mt19937 random(seed);
  Image image{width, height, {}};
  for (int i = 0; i < 4 * width * height; ++i) image.rgba.push_back(static_cast<float>(random() >> 8) / (1 << 23) - 0.25f);
  return image;
}

std::vector<uint64_t> bits_of(const ErrorReport& report) {
  std::vector<uint64_t> bits;
  for (const ErrorFigures& f : {report.covered, report.frame})
    for (const double value : {f.psnr_db, f.ssim, f.flip, f.rmse_linear, f.max_linear})
      bits.push_back(std::bit_cast<uint64_t>(value));
  for (const float value : report.flip) bits.push_back(std::bit_cast<uint32_t>(value));
  return bits;
}

TEST(MeasureError, HoldsEachMetricOverCoverAndFrame) {
  const Image test = linear_noise(30, 20, 1), reference = linear_noise(30, 20, 2);
  Mask covered = whole(30, 20);
  for (size_t i = 0; i < covered.on.size(); ++i) covered.on[i] = i % 3 == 0;
  const ErrorReport report = measure_error(test, reference, covered);
  const DisplayImage shown = to_display(test), shown_reference = to_display(reference);
  EXPECT_EQ(report.flip, flip_map(shown, shown_reference));
  for (const auto& [figures, mask] : {std::pair{report.covered, &covered}, {report.frame, static_cast<Mask*>(nullptr)}}) {
    EXPECT_EQ(figures.psnr_db, psnr_db(shown, shown_reference, mask));
    EXPECT_EQ(figures.ssim, ssim(shown, shown_reference, mask));
    EXPECT_EQ(figures.flip, flip_mean(report.flip, mask));
    EXPECT_EQ(figures.rmse_linear, rmse_linear(test, reference, mask));
    EXPECT_EQ(figures.max_linear, max_linear(test, reference, mask));
  }
  EXPECT_NE(report.covered.rmse_linear, report.frame.rmse_linear);
}

TEST(MeasureError, IsPerfectForEqualPictures) {
  const Image image = linear_noise(30, 20, 1);
  const ErrorReport report = measure_error(image, image, whole(30, 20));
  for (const ErrorFigures& figures : {report.covered, report.frame}) {
    EXPECT_EQ(figures.psnr_db, infinite);
    EXPECT_EQ(figures.ssim, 1);
    EXPECT_EQ(figures.flip, 0);
    EXPECT_EQ(figures.rmse_linear, 0);
    EXPECT_EQ(figures.max_linear, 0);
  }
}

TEST(MeasureError, IsPerfectOverACoverFarFromTheOnlyDifference) {
  const Image reference = linear_noise(60, 20, 1);
  Image test = reference;
  for (size_t channel = 0; channel < 3; ++channel) test.rgba[channel] += 0.5f;  // the pixel at 0, 0
  Mask covered = whole(60, 20);
  for (size_t i = 0; i < covered.on.size(); ++i) covered.on[i] = i % 60 > 10;  // beyond FLIP's radius of 10 and SSIM's of 5
  const ErrorReport report = measure_error(test, reference, covered);
  EXPECT_EQ(report.covered.psnr_db, infinite);
  EXPECT_EQ(report.covered.ssim, 1);
  EXPECT_EQ(report.covered.flip, 0);
  EXPECT_EQ(report.covered.rmse_linear, 0);
  EXPECT_EQ(report.covered.max_linear, 0);
  EXPECT_LT(report.frame.psnr_db, infinite);
  EXPECT_LT(report.frame.ssim, 1);
  EXPECT_GT(report.frame.flip, 0);
  EXPECT_GT(report.frame.rmse_linear, 0);
  EXPECT_EQ(report.frame.max_linear, 0.5);
}

TEST(MeasureError, IsTheSameBitForBitFromRunToRun) {
  const Image test = linear_noise(203, 101, 1), reference = linear_noise(203, 101, 2);
  const Mask covered = whole(203, 101);
  const std::vector<uint64_t> first = bits_of(measure_error(test, reference, covered));
  for (int run = 0; run < 3; ++run) ASSERT_EQ(bits_of(measure_error(test, reference, covered)), first);
}

TEST(MeasureError, RefusesAnyPixelThatIsNotFinite) {
  const Image good = linear_noise(8, 8, 1);
  Mask covered = whole(8, 8);
  covered.on[5] = 0;
  for (const float value : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    for (const size_t channel : {0, 1, 2, 3}) {
      Image bad = good;
      bad.rgba[4 * 5 + channel] = value;  // a pixel outside the cover
      EXPECT_NE(refusal([&] { measure_error(bad, good, covered); }).find("comparison: 1 of 64 pixels of the test picture"),
                std::string::npos);
      EXPECT_NE(refusal([&] { measure_error(good, bad, covered); }).find("comparison: 1 of 64 pixels of the reference"),
                std::string::npos);
    }
  }
}

TEST(MeasureError, RefusesAnEmptyCoverAndTwoSizes) {
  const Image image = linear_noise(8, 8, 1);
  const Mask none{8, 8, std::vector<uint8_t>(64)};
  EXPECT_NE(refusal([&] { measure_error(image, image, none); }).find("comparison: no pixel is counted"), std::string::npos);
  EXPECT_NE(refusal([&] { measure_error(image, image, whole(8, 7)); }).find("the mask is 8 x 7"), std::string::npos);
  EXPECT_NE(refusal([&] { measure_error(image, linear_noise(8, 7, 1), whole(8, 8)); }).find("reference 8 x 7"),
            std::string::npos);
}

}  // namespace
}  // namespace lamina
