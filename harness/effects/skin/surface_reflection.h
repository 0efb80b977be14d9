// SPDX-License-Identifier: Apache-2.0
// The surface's own reflection, in doubles: Kelemen and Szirmay-Kalos' with Beckmann's distribution (d'Eon and Luebke, GPU Gems
// 3, chapter 14), without 1/pi, as the diffuse light of the harness is.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

namespace lamina {

// exp(-tan^2 / m^2) / (m^2 cos^4) at the cosine N.H; 0 at 0.
double beckmann(double cosine, double slope);
// Unit vectors; times N.L. Opposite directions reflect nothing.
double kelemen_reflection(glm::dvec3 normal, glm::dvec3 to_light, glm::dvec3 to_eye, double slope, double reflectance);
double schlick_reflectance(double cosine, double reflectance);

class SurfaceReflection {
 public:
  explicit SurfaceReflection(double reflectance);
  // The share of light from a direction that is sent back, by its cosine to the normal; from 0 to 1.
  double share(double cosine, double slope) const;

 private:
  static constexpr size_t steps_ = 24;
  std::vector<double> table_;  // [slope][cosine]
};
// The same without the table.
double reflected_share(double cosine, double slope, double reflectance, int steps = 96);

}  // namespace lamina
