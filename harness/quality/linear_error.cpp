// SPDX-License-Identifier: Apache-2.0
// Errors in linear light, r, g and b alike, unbounded. Sums are in double, in the order of the pixels.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "harness/quality/pixels.h"

namespace lamina {
namespace {

// Of a pixel's four values.
struct Channels {
  size_t first, end;
};
constexpr Channels colour = {0, 3}, alpha = {3, 4};

// Calls `each` with every difference of a counted pixel, and returns how many pixels that were.
template <class Each>
size_t for_differences(std::string_view figure, const Image& test, const Image& reference, const Mask* mask, Channels channels,
                       Each each) {
  check_pair(figure, test, reference);
  check_mask(figure, mask, test.width, test.height);
  const size_t pixels = test.rgba.size() / 4, counted = counted_pixels(figure, mask, pixels);
  for (size_t pixel = 0; pixel < pixels; ++pixel) {
    if (!counts(mask, pixel)) continue;
    if (!is_finite_pixel(test, pixel)) check_finite(figure, test, "test");  // throws, with place and count
    if (!is_finite_pixel(reference, pixel)) check_finite(figure, reference, "reference");
    for (size_t i = 4 * pixel + channels.first; i < 4 * pixel + channels.end; ++i)
      each(double{test.rgba[i]} - double{reference.rgba[i]});
  }
  return counted;
}

}  // namespace

double rmse_linear(const Image& test, const Image& reference, const Mask* mask) {
  double squares = 0;
  const size_t counted = for_differences("RMSE", test, reference, mask, colour, [&](double d) { squares += d * d; });
  return std::sqrt(squares / (3 * static_cast<double>(counted)));
}

double max_linear(const Image& test, const Image& reference, const Mask* mask) {
  double greatest = 0;
  for_differences("maximum", test, reference, mask, colour, [&](double d) { greatest = std::max(greatest, std::abs(d)); });
  return greatest;
}

double max_alpha(const Image& test, const Image& reference, const Mask* mask) {
  double greatest = 0;
  for_differences("alpha", test, reference, mask, alpha, [&](double d) { greatest = std::max(greatest, std::abs(d)); });
  return greatest;
}

double range_linear(const Image& picture, const Mask* mask) {
  check_picture("range", picture);
  check_mask("range", mask, picture.width, picture.height);
  const size_t pixels = picture.rgba.size() / 4;
  counted_pixels("range", mask, pixels);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> least = {infinity, infinity, infinity}, most = {-infinity, -infinity, -infinity};
  for (size_t pixel = 0; pixel < pixels; ++pixel) {
    if (!counts(mask, pixel)) continue;
    if (!is_finite_pixel(picture, pixel)) check_finite("range", picture, "picture");  // throws, with place and count
    for (size_t channel = 0; channel < 3; ++channel) {
      const double value = picture.rgba[4 * pixel + channel];
      least[channel] = std::min(least[channel], value), most[channel] = std::max(most[channel], value);
    }
  }
  return std::max({most[0] - least[0], most[1] - least[1], most[2] - least[2]});
}

size_t nonfinite_pixels(const Image& image) {
  check_picture("non-finite pixels", image);
  size_t bad = 0;
  for (size_t pixel = 0; pixel < image.rgba.size() / 4; ++pixel) bad += !is_finite_pixel(image, pixel);
  return bad;
}

}  // namespace lamina
