// SPDX-License-Identifier: Apache-2.0
// The shape of the built-in heart as an implicit surface: ventricles, atria and auricles are tapered ellipsoids, the great
// vessels bent tubes cut off at their ends, all in one smooth union. About 2.7 m tall: modelled large, since nothing in its
// shading has a length of its own. x points to the heart's left (the viewer's right from the front), y up, z to the front.
// Sources: Quilez, "Smooth minimum" (2013) and "Ellipsoid - SDF" (2008), iquilezles.org. Proportions by eye from anatomy.
// Limits: distances are first-order estimates, good near the surface.
#pragma once

#include <glm/glm.hpp>

namespace lamina {

// Runs from the middle of the heart's base to its apex.
inline constexpr glm::vec3 heart_base{-0.14f, 0.34f, -0.04f};
inline constexpr glm::vec3 heart_apex{0.56f, -1.10f, 0.20f};

// What is where, for texturing. Distances in metres.
struct HeartRegions {
  float sulcus = 0;                          // 0 along the groove between the ventricles; > 0 on the right ventricle's side
  float base = 0;                            // 0 along the groove between ventricles and atria; > 0 on the atria's side
  float tube = 0;                            // > 0 on the great vessels, < 0 on the heart itself
  float aorta = 0, pulmonary = 0, cava = 0;  // shares of the three kinds of vessel, sum 1; meaningful where tube > 0
  float lumen = 0;                           // > 0 in the opening that shows on a vessel's cut end
};

// `growth` in [0, 1] lets vessels and auricles grow out of a star-shaped body, so that a mesh can follow: 0 is the body,
// from trunks_grown on the trunks have their length, from branches_grown on the branches and auricles too; at 1 their ends are
// cut.
inline constexpr float trunks_grown = 0.5f, branches_grown = 0.8f;
// Negative inside.
float heart_distance(glm::vec3 p, float growth);
// Moves a point near the surface onto it (Newton's steps along the gradient).
glm::vec3 onto_heart(glm::vec3 p, float growth, int steps);
// To the nearest of the fully grown vessels, negative inside them; `farthest` where that is less.
float vessel_distance(glm::vec3 p, float farthest);
HeartRegions heart_regions(glm::vec3 p);

}  // namespace lamina
