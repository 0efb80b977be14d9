// SPDX-License-Identifier: Apache-2.0
// A sphere, as scenes made by code use it.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// Radius 1 around the origin: six faces of a cube blown up, each a chart of its own, of face_points * face_points vertices (2 or
// more a side). Points are spread by equal angles, which keeps them about as far apart at the corners as in the middle. A closed
// hull: where faces meet, their points are equal to the last bit.
Mesh sphere_mesh(uint32_t face_points = 41);

}  // namespace lamina
