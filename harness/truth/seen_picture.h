// SPDX-License-Identifier: Apache-2.0
// A view's picture, asked what it shows of places in the world.
#pragma once

#include <glm/glm.hpp>

#include "harness/core/image.h"
#include "harness/scene/scene.h"

namespace lamina {

class SeenPicture {
 public:
  // The image outlives this; linear, the top row is 0.
  SeenPicture(const Image& image, const View& view);
  // Bilinear between pixels' middles, at what lies in the place's direction from the eye; the picture's edges are held.
  glm::dvec3 at(glm::dvec3 world) const;

 private:
  glm::dvec3 pixel(int x, int y) const;
  const Image& image_;
  glm::dvec3 ahead_, right_, up_, eye_;
  double scale_;
};

}  // namespace lamina
