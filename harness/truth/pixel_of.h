// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include "harness/core/image.h"

namespace lamina {

// The four floats of a pixel, row * width + column, of what a truth pass left.
inline glm::dvec4 pixel_of(const Image& image, size_t pixel) {
  const float* rgba = &image.rgba[4 * pixel];
  return {double(rgba[0]), double(rgba[1]), double(rgba[2]), double(rgba[3])};
}

}  // namespace lamina
