// SPDX-License-Identifier: Apache-2.0
// Which of a point's regions of visibility is which of its neighbours': so that a point's i-th aperture can be interpolated
// with the i-th ones beside it.
#pragma once

#include <span>
#include <vector>

#include "harness/bake/surface_points.h"
#include "harness/effects/aperture_lighting/apertures.h"

namespace lamina {

// Puts the apertures of each point, [point * count + i], into the order of its neighbours'. One of radius 0, whose region is
// hidden, comes to look where its region would lie, as the points around it say that see theirs.
void match_neighbours(std::vector<Aperture>& apertures, const SurfacePoints& surface, size_t count);

// Triangles with two corners whose apertures, seen or hidden, would lie nearer to each other in another order, [triangle]:
// across them nothing is interpolated rightly. `indices`: three a triangle.
std::vector<uint32_t> mismatched_triangles(const std::vector<Aperture>& apertures, std::span<const uint32_t> indices,
                                           size_t count);

}  // namespace lamina
