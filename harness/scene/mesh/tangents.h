// SPDX-License-Identifier: Apache-2.0
// Tangent frames from texture coordinates. After Lengyel, "Computing Tangent Space Basis Vectors for an Arbitrary Mesh",
// Terathon Software 2001, with each triangle weighed by its area in texture space (so that slivers of the unwrap do not rule a
// vertex) and with vertices split where triangles of both handednesses meet.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// Writes every vertex's tangent as scene.h's Vertex states it: unit, orthogonal to the normal, w = +1 or -1. Normals must be
// unit and indices in range. Where texture coordinates give no direction, the tangent is any unit vector orthogonal to the
// normal. May append vertices.
void compute_tangents(Mesh& mesh);

// Some unit vector orthogonal to a unit vector.
glm::vec3 any_orthogonal(glm::vec3 unit);

}  // namespace lamina
