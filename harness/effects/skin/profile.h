// SPDX-License-Identifier: Apache-2.0
// The diffusion profile of skin: the light that leaves its surface around a thin beam that enters, as a sum of six Gaussians
// (d'Eon and Luebke, "Advanced Techniques for Realistic Real-Time Skin Rendering", GPU Gems 3, 2007, chapter 14). Red, green
// and blue; lengths in millimetres. Where the weights sum to 1, all light comes back.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <string>

#include "harness/scene/effect_values.h"

namespace lamina {

struct DiffusionProfile {
  std::array<double, 6> variance;  // mm^2, above 0
  std::array<glm::dvec3, 6> weight;

  // At a distance from the beam, in mm^-2: sum of w exp(-r^2 / 2v) / (2 pi v).
  glm::dvec3 value(double distance_mm) const;
  // Of a flat plate: what leaves it within a disc around the beam; at a distance from a line of light, in mm^-1; and at a
  // signed distance from the edge of a lit half, above 0 on the dark side.
  glm::dvec3 inside_disc(double radius_mm) const;
  glm::dvec3 line_of_light(double distance_mm) const;
  glm::dvec3 edge_of_light(double distance_mm) const;
  // Of a sphere under a directional light of irradiance 1, at the cosine N.L, with distances along chords: each Gaussian is a
  // spherical one of sharpness R^2 / v.
  glm::dvec3 sphere(double cosine, double radius_mm) const;
  // Through a slab that is lit on its other side, as translucent shadow maps and iryoku's transmittance have it: sum of
  // w exp(-d^2 / 2v).
  glm::dvec3 transmitted(double thickness_mm) const;
};

// Of an object's numbers.
DiffusionProfile profile_of(const EffectValues& values);
// Why it is no profile ("the red weights sum to 0.9 ..."); "" where it is one.
std::string profile_problem(const DiffusionProfile& profile);

}  // namespace lamina
