// SPDX-License-Identifier: Apache-2.0
// FLIP against its formulas written out term by term: whole two-dimensional kernels, YCxCz with its scales, in double.
// Source: Andersson et al., "FLIP: A Difference Evaluator for Alternating Images", HPG 2020.
#include <cmath>
#include <functional>
#include <numbers>

#include "tests/quality/pictures.h"

namespace lamina {
namespace {

using std::numbers::pi;
using Colour = std::array<double, 3>;
using Pixels = std::vector<Colour>;
using Kernel = std::function<double(int, int)>;

struct Frame {
  int width, height;
  double pixels_per_degree;
};

Colour xyz_of(const Colour& linear) {
  const auto [r, g, b] = linear;
  return {(10135552 * r + 8788810 * g + 4435075 * b) / 24577794, (2613072 * r + 8788810 * g + 887015 * b) / 12288897,
          (1425312 * r + 8788810 * g + 70074185 * b) / 73733382};
}

// By Cramer's rule on the columns, the colours of the three primaries.
Colour linear_of(const Colour& xyz) {
  const Colour r = xyz_of({1, 0, 0}), g = xyz_of({0, 1, 0}), b = xyz_of({0, 0, 1});
  const auto determinant = [](const Colour& u, const Colour& v, const Colour& w) {
    return u[0] * (v[1] * w[2] - v[2] * w[1]) - v[0] * (u[1] * w[2] - u[2] * w[1]) + w[0] * (u[1] * v[2] - u[2] * v[1]);
  };
  const double whole = determinant(r, g, b);
  return {determinant(xyz, g, b) / whole, determinant(r, xyz, b) / whole, determinant(r, g, xyz) / whole};
}

const Colour white = xyz_of({1, 1, 1});

Colour ycxcz_of(const Colour& linear) {
  const auto [x, y, z] = xyz_of(linear);
  return {116 * y / white[1] - 16, 500 * (x / white[0] - y / white[1]), 200 * (y / white[1] - z / white[2])};
}

Colour linear_from_ycxcz(const Colour& ycxcz) {
  const double y = (ycxcz[0] + 16) / 116;
  return linear_of({white[0] * (y + ycxcz[1] / 500), white[1] * y, white[2] * (y - ycxcz[2] / 200)});
}

Colour hunt_lab_of(const Colour& linear) {
  const Colour xyz = xyz_of(linear);
  const auto f = [&](int i) {
    const double t = xyz[i] / white[i];
    return t > std::pow(6.0 / 29, 3) ? std::cbrt(t) : t * std::pow(29.0 / 6, 2) / 3 + 4.0 / 29;
  };
  const double lightness = 116 * f(1) - 16;
  return {lightness, 0.01 * lightness * 500 * (f(0) - f(1)), 0.01 * lightness * 200 * (f(1) - f(2))};
}

double hyab(const Colour& a, const Colour& b) { return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]); }

// One channel under a kernel at one place; beyond the border the edge pixel repeats.
double under(const Kernel& kernel, int radius, const Pixels& pixels, int channel, const Frame& frame, int x, int y) {
  double sum = 0;
  for (int j = -radius; j <= radius; ++j)
    for (int i = -radius; i <= radius; ++i) {
      const int row = std::clamp(y + j, 0, frame.height - 1), column = std::clamp(x + i, 0, frame.width - 1);
      sum += kernel(i, j) * pixels[row * frame.width + column][channel];
    }
  return sum;
}

// The kernel's weights of one sign, added up.
double weight_of(const Kernel& kernel, int radius, int sign) {
  double sum = 0;
  for (int j = -radius; j <= radius; ++j)
    for (int i = -radius; i <= radius; ++i) sum += std::max(sign * kernel(i, j), 0.0);
  return sum;
}

Kernel scaled_by_sign(const Kernel& kernel, int radius) {
  const double positive = weight_of(kernel, radius, 1), negative = weight_of(kernel, radius, -1);
  return [=](int i, int j) { return kernel(i, j) / (kernel(i, j) > 0 ? positive : negative > 0 ? negative : 1); };
}

Pixels ycxcz_pixels(const DisplayImage& image) {
  const auto decoded = [](uint8_t code) {
    const double s = code / 255.0;
    return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
  };
  Pixels pixels;
  for (size_t i = 0; i < image.rgb.size(); i += 3)
    pixels.push_back(ycxcz_of({decoded(image.rgb[i]), decoded(image.rgb[i + 1]), decoded(image.rgb[i + 2])}));
  return pixels;
}

Pixels seen_pixels(const Pixels& ycxcz, const Frame& frame) {
  const double p = frame.pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3 * p * std::sqrt(0.04 / (2 * pi * pi))));
  const auto gaussian = [p](double a, double b) -> Kernel {
    return [=](int i, int j) { return a * std::sqrt(pi / b) * std::exp(-pi * pi * (i * i + j * j) / (p * p) / b); };
  };
  const Kernel wide = gaussian(34.1, 0.04), narrow = gaussian(13.5, 0.025);
  const Kernel sensitivity[] = {scaled_by_sign(gaussian(1, 0.0047), radius), scaled_by_sign(gaussian(1, 0.0053), radius),
                                scaled_by_sign([&](int i, int j) { return wide(i, j) + narrow(i, j); }, radius)};
  Pixels seen;
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      Colour filtered;
      for (int channel = 0; channel < 3; ++channel)
        filtered[channel] = under(sensitivity[channel], radius, ycxcz, channel, frame, x, y);
      Colour linear = linear_from_ycxcz(filtered);
      for (double& value : linear) value = std::clamp(value, 0.0, 1.0);
      seen.push_back(hunt_lab_of(linear));
    }
  return seen;
}

// Edge and point strength at each pixel.
std::vector<std::array<double, 2>> features_of(const Pixels& ycxcz, const Frame& frame) {
  const double sigma = 0.5 * 0.082 * frame.pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3 * sigma));
  const auto gaussian = [=](int i, int j) { return std::exp(-(i * i + j * j) / (2 * sigma * sigma)); };
  const auto edge = [&](int i, int j) { return -i * gaussian(i, j); };
  const auto point = [&](int i, int j) { return (i * i / (sigma * sigma) - 1) * gaussian(i, j); };
  const Kernel detectors[] = {scaled_by_sign(edge, radius), scaled_by_sign(point, radius)};
  Pixels luminance = ycxcz;
  for (Colour& pixel : luminance) pixel[0] = (pixel[0] + 16) / 116;
  std::vector<std::array<double, 2>> features;
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      const auto strength = [&](const Kernel& kernel) {
        const Kernel turned = [&](int i, int j) { return kernel(j, i); };
        return std::hypot(under(kernel, radius, luminance, 0, frame, x, y), under(turned, radius, luminance, 0, frame, x, y));
      };
      features.push_back({strength(detectors[0]), strength(detectors[1])});
    }
  return features;
}

std::vector<double> plain_flip(const DisplayImage& test, const DisplayImage& reference, double pixels_per_degree) {
  const Frame frame{test.width, test.height, pixels_per_degree};
  const Pixels a = ycxcz_pixels(test), b = ycxcz_pixels(reference);
  const Pixels seen_a = seen_pixels(a, frame), seen_b = seen_pixels(b, frame);
  const auto features_a = features_of(a, frame), features_b = features_of(b, frame);
  const double greatest = std::pow(hyab(hunt_lab_of({0, 1, 0}), hunt_lab_of({0, 0, 1})), 0.7), knee = 0.4 * greatest;
  std::vector<double> map;
  for (size_t i = 0; i < a.size(); ++i) {
    const double d = std::pow(hyab(seen_a[i], seen_b[i]), 0.7);
    const double colour = d < knee ? 0.95 * d / knee : 0.95 + 0.05 * (d - knee) / (greatest - knee);
    const double edge = std::abs(features_a[i][0] - features_b[i][0]), point = std::abs(features_a[i][1] - features_b[i][1]);
    map.push_back(std::pow(colour, 1 - std::sqrt(std::max(edge, point) / std::numbers::sqrt2)));
  }
  return map;
}

void expect_the_formulas_map(const DisplayImage& test, const DisplayImage& reference, double pixels_per_degree) {
  const std::vector<float> map = flip_map(test, reference, pixels_per_degree);
  const std::vector<double> plain = plain_flip(test, reference, pixels_per_degree);
  ASSERT_EQ(map.size(), plain.size());
  for (size_t i = 0; i < map.size(); ++i) ASSERT_NEAR(map[i], plain[i], 1e-4) << "pixel " << i << ", ppd " << pixels_per_degree;
}

TEST(FlipFormula, HoldsOnNoiseAtEveryDistance) {
  for (const double pixels_per_degree : {5.0, 30.0, default_pixels_per_degree})
    expect_the_formulas_map(noise(19, 14, 1), noise(19, 14, 2), pixels_per_degree);
}

TEST(FlipFormula, HoldsOnSaturatedPatterns) {
  // Blue and yellow stripes against shifted ones: the widest filter, and filtered colours that no display can show.
  const auto stripes = [](int shift) {
    return painted(30, 12, [=](int x, int) { return (x + shift) / 4 % 2 ? Colour8{0, 0, 255} : Colour8{255, 255, 0}; });
  };
  const auto red = painted(30, 12, [](int x, int y) { return x == 15 && y > 4 ? Colour8{255, 0, 0} : Colour8{255, 255, 255}; });
  expect_the_formulas_map(stripes(0), stripes(2), default_pixels_per_degree);
  expect_the_formulas_map(red, flat(30, 12, grey(255)), 40);
}

TEST(FlipFormula, HoldsOnPicturesSmallerThanTheKernels) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 25}, {25, 1}, {3, 2}})
    expect_the_formulas_map(noise(width, height, 3), noise(width, height, 4), default_pixels_per_degree);
}

}  // namespace
}  // namespace lamina
