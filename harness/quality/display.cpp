// SPDX-License-Identifier: Apache-2.0
// From linear light to what a display is sent: 8-bit sRGB.
#include <tbb/parallel_for.h>

#include <cmath>

#include "harness/core/error.h"
#include "harness/core/srgb.h"
#include "harness/quality/pixels.h"

namespace lamina {

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
        display.rgb[3 * pixel + channel] = srgb_code(linear.rgba[4 * pixel + channel]);
  });
  return display;
}

}  // namespace lamina
