// SPDX-License-Identifier: Apache-2.0
// Pictures to measure, and the question every metric is asked: does it refuse?
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <random>

#include "harness/core/error.h"
#include "harness/quality/quality.h"

namespace lamina {

inline constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();

using Colour8 = std::array<int, 3>;  // r, g, b from 0 to 255

// colour(x, y) gives r, g, b as integers; only their low eight bits are kept.
template <class Colour>
DisplayImage painted(int width, int height, Colour colour) {
  DisplayImage image{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int value : Colour8(colour(x, y))) image.rgb.push_back(static_cast<uint8_t>(value));
  return image;
}

inline Colour8 grey(int code) { return {code, code, code}; }

inline DisplayImage flat(int width, int height, Colour8 colour) {
  return painted(width, height, [&](int, int) { return colour; });
}

// Every channel of every pixel by itself. mt19937's numbers are fixed by the C++ standard.
inline DisplayImage noise(int width, int height, uint32_t seed) {
  std::mt19937 random(seed);
  const auto code = [&] { return static_cast<int>(random() >> 24); };
  return painted(width, height, [&](int, int) { return Colour8{code(), code(), code()}; });
}

inline Image flat_linear(int width, int height, float value) {
  return {width, height, std::vector<float>(static_cast<size_t>(width * height) * 4, value)};
}

inline Mask whole(int width, int height) {
  return {width, height, std::vector<uint8_t>(static_cast<size_t>(width * height), 1)};
}

// The words of the Error(failed) of stage "quality" that `call` throws; "" where it throws none.
template <class Call>
std::string refusal(Call call) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::failed);
    EXPECT_EQ(error.stage(), "quality");
    return error.what();
  }
  return "";
}

}  // namespace lamina
