// SPDX-License-Identifier: Apache-2.0
// From linear light to what a display is sent: 8-bit sRGB.
// Source: IEC 61966-2-1:1999, "Default RGB colour space - sRGB": the transfer functions and their five constants.
#include <tbb/parallel_for.h>

#include <algorithm>
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

DisplayImage to_display(const Image& linear) {
  check_picture("display picture", linear);
  DisplayImage display{linear.width, linear.height, {}};
  const size_t pixels = linear.rgba.size() / 4, width = static_cast<size_t>(linear.width);
  for (size_t pixel = 0; pixel < pixels; ++pixel)
    for (size_t channel = 0; channel < 3; ++channel)
      if (std::isnan(linear.rgba[4 * pixel + channel]))
        check_finite("display picture", linear, "rendered");  // throws: where, how many
  display.rgb.resize(3 * pixels);
  tbb::parallel_for(size_t{0}, static_cast<size_t>(linear.height), [&](size_t y) {
    for (size_t pixel = y * width; pixel < (y + 1) * width; ++pixel)
      for (size_t channel = 0; channel < 3; ++channel)
        display.rgb[3 * pixel + channel] =
            static_cast<uint8_t>(std::lround(255 * srgb_encode(std::clamp(linear.rgba[4 * pixel + channel], 0.f, 1.f))));
  });
  return display;
}

}  // namespace lamina
