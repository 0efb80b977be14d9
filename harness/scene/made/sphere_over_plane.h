// SPDX-License-Identifier: Apache-2.0
// The built-in scene `sphere_over_plane`: a sphere that hovers just above a plane. Under it the plane sees a band around the
// horizon and nothing above, which no aperture can be: the case in which ambient aperture lighting fails by its nature. After
// Oat, "Efficient Shader Tricks That Will Impress Your Friends", GDC 2006, part 2.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// Nothing moves. Objects "plane" and "sphere"; the sphere's radius is 1 m, its centre above the origin.
Scene make_sphere_over_plane();

}  // namespace lamina
