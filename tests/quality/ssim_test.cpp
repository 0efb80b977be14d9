// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numeric>
#include <opencv2/quality/qualityssim.hpp>

#include "tests/quality/pictures.h"

namespace lamina {
namespace {

// Index -1 is 1, index n is n - 2, and so on: the border is a mirror that does not repeat the edge pixel.
int mirrored(int i, int n) {
  if (n == 1) return 0;
  const int period = 2 * (n - 1), j = ((i % period) + period) % period;
  return std::min(j, period - j);
}

// Equation 13 of the 2004 paper, term by term, with its K1 = 0.01, K2 = 0.03, L = 255 and 11x11 Gaussian window of sigma 1.5.
std::vector<double> paper_ssim(const DisplayImage& a, const DisplayImage& b) {
  const double c1 = std::pow(0.01 * 255, 2), c2 = std::pow(0.03 * 255, 2);
  double window[11][11], total = 0;
  for (int y = 0; y < 11; ++y)
    for (int x = 0; x < 11; ++x) total += window[y][x] = std::exp(-((x - 5) * (x - 5) + (y - 5) * (y - 5)) / (2 * 1.5 * 1.5));
  std::vector<double> pixels;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      double sum = 0;
      for (int channel = 0; channel < 3; ++channel) {
        const auto expectation = [&](const auto& f) {
          double weighted = 0;
          for (int j = 0; j < 11; ++j)
            for (int i = 0; i < 11; ++i) {
              const int at = 3 * (mirrored(y + j - 5, a.height) * a.width + mirrored(x + i - 5, a.width)) + channel;
              weighted += window[j][i] / total * f(double{0} + a.rgb[at], double{0} + b.rgb[at]);
            }
          return weighted;
        };
        const double mean_a = expectation([](double p, double) { return p; });
        const double mean_b = expectation([](double, double q) { return q; });
        const double variance_a = expectation([&](double p, double) { return (p - mean_a) * (p - mean_a); });
        const double variance_b = expectation([&](double, double q) { return (q - mean_b) * (q - mean_b); });
        const double covariance = expectation([&](double p, double q) { return (p - mean_a) * (q - mean_b); });
        sum += (2 * mean_a * mean_b + c1) * (2 * covariance + c2) /
               ((mean_a * mean_a + mean_b * mean_b + c1) * (variance_a + variance_b + c2));
      }
      pixels.push_back(sum / 3);
    }
  return pixels;
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

TEST(Ssim, AgreesWithThePapersFormula) {
  const DisplayImage a = noise(23, 19, 1);
  const DisplayImage smooth = painted(23, 19, [](int x, int y) { return Colour8{9 * x, 200 - 3 * y, 40 + x * y / 4}; });
  const DisplayImage bright = painted(23, 19, [](int x, int y) { return grey(250 + (x + y) % 3); });
  for (const auto& [test, reference] : {std::pair{a, noise(23, 19, 2)}, {smooth, a}, {bright, flat(23, 19, grey(251))}})
    EXPECT_NEAR(ssim(test, reference), mean_of(paper_ssim(test, reference)), 1e-6);
}

// Nearly equal bright pictures: their variances are small differences of large numbers. Reports print six digits near 1.
TEST(Ssim, HoldsDigitsThatFloatsLose) {
  const DisplayImage dither = noise(64, 48, 3);
  const auto bright = [&](int period) {
    return painted(64, 48, [&](int x, int y) {
      const int i = 64 * y + x;
      return grey(250 + dither.rgb[static_cast<size_t>(3 * i)] % 2 + (i % period == 0 ? 1 : 0));
    });
  };
  const DisplayImage reference = bright(1 << 20), test = bright(8);
  const double exact = mean_of(paper_ssim(test, reference));
  EXPECT_NEAR(ssim(test, reference), exact, 1e-9);
  const auto bytes = [](const DisplayImage& image) {
    return cv::Mat3b(image.height, image.width, reinterpret_cast<cv::Vec3b*>(const_cast<uint8_t*>(image.rgb.data())));
  };
  cv::Mat map;
  cv::quality::QualitySSIM::compute(bytes(reference), bytes(test), map);  // works in floats
  const cv::Scalar in_floats = cv::mean(map);
  EXPECT_GT(std::abs(in_floats[0] - exact), 1e-7);
}

TEST(Ssim, AgreesWithThePapersFormulaOnPicturesSmallerThanItsWindow) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 9}, {9, 1}, {2, 3}, {10, 10}}) {
    const DisplayImage a = noise(width, height, 3), b = noise(width, height, 4);
    EXPECT_NEAR(ssim(a, b), mean_of(paper_ssim(a, b)), 1e-6) << width << " x " << height;
  }
}

TEST(Ssim, OfFlatPicturesIsTheLuminanceTermAlone) {
  // Variances are zero: (2 a b + C1) / (a^2 + b^2 + C1), C1 = 6.5025. Black against white: nearly 0.
  EXPECT_NEAR(ssim(flat(20, 20, grey(100)), flat(20, 20, grey(110))), 22006.5025 / 22106.5025, 1e-9);
  EXPECT_NEAR(ssim(flat(20, 20, grey(0)), flat(20, 20, grey(255))), 6.5025 / 65031.5025, 1e-9);
}

TEST(Ssim, IsExactlyOneForEqualPictures) {
  for (const int size : {1, 7, 49, 130}) EXPECT_EQ(ssim(noise(size, size, 5), noise(size, size, 5)), 1) << size;
}

TEST(Ssim, IsSymmetric) {
  EXPECT_NEAR(ssim(noise(30, 20, 1), noise(30, 20, 2)), ssim(noise(30, 20, 2), noise(30, 20, 1)), 1e-12);
}

TEST(Ssim, CountsOnlyTheMask) {
  const DisplayImage a = noise(40, 16, 1);
  DisplayImage b = a;
  for (int y = 0; y < 16; ++y) b.rgb[3 * (40 * y + 2)] ^= 0x80;  // one column, at x = 2
  Mask mask = whole(40, 16);
  EXPECT_EQ(ssim(b, a, &mask), ssim(b, a));
  EXPECT_LT(ssim(b, a), 1);
  const std::vector<double> expected = paper_ssim(b, a);
  double sum = 0;
  for (int i = 0; i < 40 * 16; ++i) {
    mask.on[i] = i % 40 < 4;
    if (mask.on[i]) sum += expected[i];
  }
  EXPECT_NEAR(ssim(b, a, &mask), sum / (4 * 16), 1e-6);
  for (int i = 0; i < 40 * 16; ++i) mask.on[i] = i % 40 > 2 + 5;  // windows of these pixels do not reach the column
  EXPECT_EQ(ssim(b, a, &mask), 1);
}

TEST(Ssim, RefusesWhatHasNoFigure) {
  const DisplayImage a = flat(4, 3, grey(1));
  const Mask none{4, 3, std::vector<uint8_t>(12)}, other = whole(3, 4);
  EXPECT_NE(refusal([&] { ssim(a, flat(3, 4, grey(1))); }).find("test is 4 x 3 pixels, reference 3 x 4"), std::string::npos);
  EXPECT_NE(refusal([&] { ssim({}, {}); }).find("empty"), std::string::npos);
  EXPECT_NE(refusal([&] { ssim(a, a, &none); }).find("no pixel is counted"), std::string::npos);
  EXPECT_NE(refusal([&] { ssim(a, a, &other); }).find("the mask is 3 x 4"), std::string::npos);
}

}  // namespace
}  // namespace lamina
