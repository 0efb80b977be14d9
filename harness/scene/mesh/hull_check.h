// SPDX-License-Identifier: Apache-2.0
// Whether a mesh is a hull: closed, with all faces turned the same way, so that a ray from outside crosses it in pairs of faces
// and what lies inside is known.
#pragma once

#include <optional>
#include <string>

#include "harness/scene/scene.h"

namespace lamina {

// None, or why the mesh is not a hull, with the place in object space of the first edge that shows it. Along every edge, as
// many faces must run one way as the other. Vertices at exactly one place are one, for meshes split them at seams. A vertex in
// the middle of a neighbour's edge leaves that edge open. Triangles with two equal corners do not count. Several hulls in one
// mesh may touch at edges, and may be turned inside out: those are holes, of negative volume. Time is linear in the triangles.
std::optional<std::string> hull_problem(const Mesh& mesh);

// Whether some edge belongs to one triangle alone: only then can backs be seen from outside. Vertices and triangles as above.
bool has_open_edge(const Mesh& mesh);

}  // namespace lamina
