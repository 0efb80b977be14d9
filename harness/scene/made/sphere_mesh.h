// SPDX-License-Identifier: Apache-2.0
// A sphere, as scenes made by code use it.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// Radius 1 around the origin: six faces of a cube blown up, each a chart of its own, of face_points * face_points vertices (2
// or more a side). Points are spread by equal angles, which keeps them about as far apart at the corners as in the middle. A
// closed hull: where faces meet, their points are equal to the last bit.
Mesh sphere_mesh(uint32_t face_points = 41);

// The same with a spherical hole of this radius (below 1) around its middle, a hull turned inside out.
Mesh shell_mesh(float hole, uint32_t face_points = 41);

// A sphere made into a thin, bent form, as of a leaf or an ear: scaled by `half_m` along the axes, then z raised by bend_per_m
// x^2 (metres). As closed as the sphere.
Mesh bent_disc_mesh(glm::vec3 half_m, float bend_per_m, uint32_t face_points = 41);

}  // namespace lamina
