// SPDX-License-Identifier: Apache-2.0
// What is known of skin before any frame: that its profile is one, and how much its surface bends.
#pragma once

#include "harness/bake/baker.h"
#include "harness/scene/scene.h"

namespace lamina {

// Buffer "Curvatures": the mean curvature of each vertex in 1/mm, above 0 where the surface bulges (a sphere's is 1 / R); the
// mean over edges of how far normals turn a metre, smoothed over neighbours. Throws Error(bad_input) for a wrong profile.
extern const BakerCode skin_baker;

// Beside the mesh's vertices, in 1/m of object space. Vertices of one place, as at a seam, count as one.
std::vector<float> mean_curvatures(const Mesh& mesh);

}  // namespace lamina
