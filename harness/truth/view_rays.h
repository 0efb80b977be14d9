// SPDX-License-Identifier: Apache-2.0
// The rays of a view through the middles of its pixels, or any place of its picture, in doubles.
#pragma once

#include <glm/glm.hpp>

#include "harness/scene/scene.h"

namespace lamina {

class ViewRays {
 public:
  ViewRays(const View& view, int width_px, int height_px);
  // Unit, in the world; the top row is 0.
  glm::dvec3 direction(int column, int row) const { return through(column + 0.5, row + 0.5); }
  // Through a place of the picture, in pixels from its top left corner.
  glm::dvec3 through(double x_px, double y_px) const;
  // Of the pixel row * width + column.
  glm::dvec3 direction(size_t pixel) const;
  // Unit, along the view's axis.
  glm::dvec3 ahead() const { return ahead_; }

 private:
  glm::dvec3 ahead_, right_, up_;
  double half_height_;  // tangent of half the angle of view
  int width_px_, height_px_;
};

}  // namespace lamina
