// SPDX-License-Identifier: Apache-2.0
// What each pixel of a view shows, as the device drew it: so that an offline answer is about the same points, to the last bit
// of rasterization.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "harness/core/image.h"
#include "harness/effects/aperture_lighting/apertures.h"

namespace lamina {

struct ShadingPoint {
  size_t pixel = 0;                             // row * width + column
  glm::vec3 position{0}, normal{0}, albedo{0};  // world, unit, linear
};

struct ShadingPoints {
  int width = 0, height = 0;
  std::vector<ShadingPoint> points;  // of the pixels that the effect covers, row by row
  ApertureKind kind;
  std::vector<Aperture> apertures;  // [point * kind.count + i]
};

// From the targets of a pass for the truth (Frequency::truth): the point with alpha above 0 where there is one,
// normal, albedo, and one picture for each aperture.
ShadingPoints shading_points(const Image& point, const Image& normal, const Image& albedo, const std::vector<Image>& apertures,
                             ApertureKind kind);

}  // namespace lamina
