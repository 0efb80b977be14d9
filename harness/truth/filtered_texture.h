// SPDX-License-Identifier: Apache-2.0
// A texture read as a device reads it: bilinear in the two nearest levels of its mip chain, repeated or as the texture wraps,
// by doubles.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "harness/scene/textures.h"

namespace lamina {

class FilteredTexture {
 public:
  explicit FilteredTexture(const TextureImage& texture);
  // `right`, `down`: the texture coordinates of the neighbouring pixels. The level is that of Khronos, Vulkan specification,
  // "Scale Factor Operation, Level-of-Detail Operation", with one sample a footprint.
  glm::dvec4 at(glm::dvec2 uv, glm::dvec2 right, glm::dvec2 down) const;
  // In the base level.
  glm::dvec4 base(glm::dvec2 uv) const { return bilinear(levels_.front(), uv); }

 private:
  static glm::dvec4 bilinear(const Texels& level, glm::dvec2 uv);
  std::vector<Texels> levels_;
};

}  // namespace lamina
