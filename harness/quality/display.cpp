// SPDX-License-Identifier: Apache-2.0
// From linear light to what a display is sent: 8-bit sRGB.
// Source: IEC 61966-2-1:1999, "Default RGB colour space - sRGB": the transfer functions and their five constants.
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "harness/core/error.h"
#include "harness/quality/pixels.h"

namespace lamina {

float srgb_encode(float linear) {
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

float srgb_decode(float encoded) {
  return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

namespace {

uint8_t srgb_code(float linear) { return static_cast<uint8_t>(std::lround(255 * srgb_encode(linear))); }

// srgb_code() by look-up, for pictures have millions of values: the code of the least float with the same upper 16 bits, and
// one more for each code that begins between the two. What lies outside [0,1] is clamped.
class SrgbCodes {
 public:
  SrgbCodes() {
    for (size_t code = 1; code < first_.size(); ++code) {
      uint32_t below = 0, at = one;
      while (at - below > 1) {
        const uint32_t middle = below + (at - below) / 2;
        (srgb_code(std::bit_cast<float>(middle)) < code ? below : at) = middle;
      }
      first_[code] = at;
    }
    for (uint32_t upper = 0; upper < least_.size(); ++upper) least_[upper] = srgb_code(std::bit_cast<float>(upper << 16));
  }
  uint8_t operator()(float linear) const {
    const auto bits = std::bit_cast<uint32_t>(std::clamp(linear, 0.f, 1.f) + 0.f);  // -0 becomes 0
    uint8_t code = least_[bits >> 16];
    while (code < 255 && bits >= first_[code + 1u]) ++code;
    return code;
  }

 private:
  static constexpr uint32_t one = std::bit_cast<uint32_t>(1.f);
  std::array<uint32_t, 256> first_{};             // by code: the bits of the least float that has it
  std::array<uint8_t, (one >> 16) + 1> least_{};  // by a float's upper bits
};

}  // namespace

DisplayImage to_display(const Image& linear) {
  check_picture("display picture", linear);
  DisplayImage display{linear.width, linear.height, {}};
  const size_t pixels = linear.rgba.size() / 4, width = static_cast<size_t>(linear.width);
  for (size_t pixel = 0; pixel < pixels; ++pixel)
    for (size_t channel = 0; channel < 3; ++channel)
      if (std::isnan(linear.rgba[4 * pixel + channel]))
        check_finite("display picture", linear, "rendered");  // throws: where, how many
  static const SrgbCodes codes;
  display.rgb.resize(3 * pixels);
  tbb::parallel_for(size_t{0}, static_cast<size_t>(linear.height), [&](size_t y) {
    for (size_t pixel = y * width; pixel < (y + 1) * width; ++pixel)
      for (size_t channel = 0; channel < 3; ++channel)
        display.rgb[3 * pixel + channel] = codes(linear.rgba[4 * pixel + channel]);
  });
  return display;
}

}  // namespace lamina
