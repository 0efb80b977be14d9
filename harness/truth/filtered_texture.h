// SPDX-License-Identifier: Apache-2.0
// A texture read as a device reads it: bilinear in the two nearest levels of its mip chain, repeated, by doubles.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "harness/core/image.h"

namespace lamina {

class FilteredTexture {
 public:
  // rgba8_unorm or rgba8_srgb.
  explicit FilteredTexture(const TextureImage& texture);
  // `right`, `down`: the texture coordinates of the neighbouring pixels. The level is that of Khronos, Vulkan specification,
  // "Scale Factor Operation, Level-of-Detail Operation", with one sample a footprint.
  glm::dvec4 at(glm::dvec2 uv, glm::dvec2 right, glm::dvec2 down) const;

 private:
  struct Level {
    int width, height;
    std::vector<glm::vec4> texels;
  };
  static glm::dvec4 bilinear(const Level& level, glm::dvec2 uv);
  std::vector<Level> levels_;
};

}  // namespace lamina
