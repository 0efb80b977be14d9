// SPDX-License-Identifier: Apache-2.0
#include "harness/truth/seen_picture.h"

#include <algorithm>
#include <cmath>

namespace lamina {

SeenPicture::SeenPicture(const Image& image, const View& view)
    : image_(image),
      ahead_(glm::normalize(glm::dvec3(view.target) - glm::dvec3(view.eye))),
      right_(glm::normalize(glm::cross(ahead_, glm::dvec3(view.up)))),
      up_(glm::cross(right_, ahead_)),
      eye_(view.eye),
      scale_(image.height / 2.0 / std::tan(glm::radians(double(view.fov_y_degrees)) / 2)) {}

glm::dvec3 SeenPicture::at(glm::dvec3 world) const {
  const glm::dvec3 seen = world - eye_;
  const double depth = std::max(glm::dot(seen, ahead_), 1e-6);
  const double x = std::clamp(image_.width / 2.0 + scale_ * glm::dot(seen, right_) / depth - 0.5, 0.0, image_.width - 1.0);
  const double y = std::clamp(image_.height / 2.0 - scale_ * glm::dot(seen, up_) / depth - 0.5, 0.0, image_.height - 1.0);
  const int left = std::min(static_cast<int>(x), image_.width - 2), top = std::min(static_cast<int>(y), image_.height - 2);
  return glm::mix(glm::mix(pixel(left, top), pixel(left + 1, top), x - left),
                  glm::mix(pixel(left, top + 1), pixel(left + 1, top + 1), x - left), y - top);
}

glm::dvec3 SeenPicture::pixel(int x, int y) const {
  const float* rgba = &image_.rgba[4 * (size_t(y) * size_t(image_.width) + size_t(x))];
  return {rgba[0], rgba[1], rgba[2]};
}

}  // namespace lamina
