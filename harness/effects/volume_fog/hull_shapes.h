// SPDX-License-Identifier: Apache-2.0
// Which hulls are boxes or ellipsoids, whose lengths along a ray are closed forms: the baker `hull_shapes`.
//
// With shapes = 1 of [bake] each object has a storage buffer `HullShape`: vec4 low, vec4 high: the bounds of its mesh in object
// space; high.w is 0 for any mesh, 1 for a box, 2 for an ellipsoid. Without, it makes nothing.
#pragma once

#include "harness/manifest/effect_code.h"
#include "harness/scene/scene.h"

namespace lamina {

extern const BakerCode hull_shape_baker;

enum class HullShape : uint8_t { any, box, ellipsoid };
// A box along the axes of object space: all triangles lie in the faces of its bounds and enclose all of them. An ellipsoid
// along them: all vertices lie on it to a ten-thousandth of its half axes, and enclose at least 97% of it. Neither where the
// mesh is turned inside out.
HullShape hull_shape(const Mesh& mesh);

}  // namespace lamina
