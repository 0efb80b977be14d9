// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "harness/core/image.h"

namespace lamina {

struct BitDifference {
  size_t pixels = 0;   // whose red, green or blue is not the same bits
  double largest = 0;  // of a channel; 1e30 where one of the two is not finite
  int x = 0, y = 0;    // where that is, first in rows; 0 where no pixel differs
};

// Alpha does not count. Throws Error(failed) where the sizes differ.
BitDifference bit_difference(const Image& a, const Image& b);

}  // namespace lamina
