// SPDX-License-Identifier: Apache-2.0
// An object that is seen through, as scenes made by code use them.
#pragma once

#include <string>

#include "harness/scene/scene.h"

namespace lamina {

struct GlassLook {
  glm::vec3 color{1};     // linear, 0 to 1
  double opacity = 0.25;  // seen straight on, 0 to 1
  double specular = 0.5, gloss = 300;
  double slant = 1;  // how much of the longer way at a slant counts
};

Object transparent_object(std::string name, Mesh mesh, const GlassLook& look);

}  // namespace lamina
