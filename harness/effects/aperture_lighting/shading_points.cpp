// SPDX-License-Identifier: Apache-2.0
#include "harness/effects/aperture_lighting/shading_points.h"

#include <cstring>

namespace lamina {
namespace {

glm::vec4 pixel(const Image& image, size_t i) {
  glm::vec4 value;
  std::memcpy(&value, &image.rgba[4 * i], sizeof value);
  return value;
}

}  // namespace

ShadingPoints shading_points(const Image& point, const Image& normal, const Image& albedo, const std::vector<Image>& apertures,
                             ApertureKind kind) {
  ShadingPoints made{point.width, point.height, {}, kind, {}};
  for (size_t i = 0; i < size_t(point.width) * size_t(point.height); ++i) {
    if (pixel(point, i).a <= 0) continue;
    made.points.push_back({i, glm::vec3(pixel(point, i)), glm::vec3(pixel(normal, i)), glm::vec3(pixel(albedo, i))});
    for (const Image& aperture : apertures) made.apertures.push_back(pixel(aperture, i));
  }
  return made;
}

}  // namespace lamina
