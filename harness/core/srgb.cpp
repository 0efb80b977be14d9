// SPDX-License-Identifier: Apache-2.0
#include "harness/core/srgb.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace lamina {
namespace {

// By look-up, for pictures have millions of values: the code of the least float with the same upper 16 bits, and one more for
// each code that begins between the two.
class Codes {
 public:
  Codes() {
    for (size_t code = 1; code < first_.size(); ++code)
      first_[code] = std::bit_cast<uint32_t>(static_cast<float>(srgb_decode((double(code) - 0.5) / 255)));
    for (uint32_t upper = 0; upper < least_.size(); ++upper)
      least_[upper] =
          static_cast<uint8_t>(std::upper_bound(first_.begin() + 1, first_.end(), upper << 16) - first_.begin() - 1);
  }
  // Of a value in (0,1].
  uint8_t of(float linear) const {
    const auto bits = std::bit_cast<uint32_t>(linear);
    uint8_t code = least_[bits >> 16];
    while (code < 255 && bits >= first_[code + 1u]) ++code;
    return code;
  }

 private:
  std::array<uint32_t, 256> first_{};                                      // by code: the bits of the least float that has it
  std::array<uint8_t, (std::bit_cast<uint32_t>(1.f) >> 16) + 1> least_{};  // by a float's upper bits
};

}  // namespace

float srgb_encode(float linear) {
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

float srgb_decode(float encoded) {
  return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

double srgb_decode(double encoded) { return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4); }

uint8_t srgb_code(float linear) {
  static const Codes codes;
  return linear > 0 ? codes.of(std::min(linear, 1.f)) : 0;
}

}  // namespace lamina
