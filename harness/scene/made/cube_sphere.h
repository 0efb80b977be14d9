// SPDX-License-Identifier: Apache-2.0
// A sphere made of the six faces of a cube blown up, each a chart of its own.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// Radius 1 m around the origin; each face has points_per_edge^2 vertices (2 or more), spread by equal angles, which keeps them
// about as far apart at the corners as in the middle. Vertices of two faces that meet at a seam stand at exactly one place, so
// the mesh is a closed hull.
Mesh cube_sphere(uint32_t points_per_edge);

}  // namespace lamina
