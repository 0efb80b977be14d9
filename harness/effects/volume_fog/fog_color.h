// SPDX-License-Identifier: Apache-2.0
// From thickness to colour as a scene says it, in doubles: what shaders are held to.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// A number that the scene's fog has; 0 where it has none of this name.
double fog_number(const Scene& scene, std::string_view name);

class FogColor {
 public:
  // Of a scene with fog.
  explicit FogColor(const Scene& scene);
  // `behind`, seen through `thickness_m` metres of fog at a share of 1; linear light. Exponential: with T = exp(-density s) it
  // is behind T + color (1 - T). A ramp: linear between its texels' centres, the first at 0 m and the last at its length and
  // beyond. Thickness below 0 is none.
  glm::dvec3 over(glm::dvec3 behind, double thickness_m) const;

 private:
  double density_ = 0, ramp_length_m_ = 0;
  glm::dvec3 color_{0};
  std::vector<glm::dvec4> ramp_;
};

}  // namespace lamina
