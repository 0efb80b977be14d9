// SPDX-License-Identifier: Apache-2.0
#include "harness/truth/view_rays.h"

#include <cmath>

namespace lamina {

ViewRays::ViewRays(const View& view, int width_px, int height_px)
    : ahead_(glm::normalize(glm::dvec3(view.target) - glm::dvec3(view.eye))),
      right_(glm::normalize(glm::cross(ahead_, glm::dvec3(view.up)))),
      up_(glm::cross(right_, ahead_)),
      half_height_(std::tan(glm::radians(static_cast<double>(view.fov_y_degrees)) / 2)),
      width_px_(width_px),
      height_px_(height_px) {}

glm::dvec3 ViewRays::through(double x_px, double y_px) const {
  const double x = (2 * x_px - width_px_) / height_px_, y = 1 - 2 * y_px / height_px_;
  return glm::normalize(ahead_ + half_height_ * (x * right_ + y * up_));
}

glm::dvec3 ViewRays::direction(size_t pixel) const {
  const auto width = static_cast<size_t>(width_px_);
  return direction(static_cast<int>(pixel % width), static_cast<int>(pixel / width));
}

}  // namespace lamina
