// SPDX-License-Identifier: Apache-2.0
#include "harness/quality/same_bits.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "harness/core/error.h"

namespace lamina {

BitDifference bit_difference(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height)
    throw Error(ErrorKind::failed, "quality", "two pictures",
                fmt::format("are {}x{} and {}x{} and cannot be compared", a.width, a.height, b.width, b.height));
  BitDifference difference;
  for (size_t i = 0; i < a.rgba.size(); i += 4) {
    double here = 0;
    bool differs = false;
    for (size_t channel = 0; channel < 3; ++channel) {
      const float one = a.rgba[i + channel], other = b.rgba[i + channel];
      if (std::bit_cast<uint32_t>(one) == std::bit_cast<uint32_t>(other)) continue;
      differs = true;
      const double apart = std::abs(double(one) - double(other));
      here = std::max(here, std::isfinite(apart) ? apart : 1e30);
    }
    if (!differs) continue;
    if (difference.pixels++ == 0 || here > difference.largest) {
      const int pixel = static_cast<int>(i / 4);
      difference.largest = here, difference.x = pixel % a.width, difference.y = pixel / a.width;
    }
  }
  return difference;
}

}  // namespace lamina
