// SPDX-License-Identifier: Apache-2.0
// The built-in scene `conical_pit`: a small floor at the bottom of a wide cone. From the middle of the floor the sky is a disc
// around the zenith, exactly; the floor is small against the pit, so that this nearly holds for all of it.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// The rim is a circle of 1 m around the y axis; from the floor's middle, the origin, it stands this far from the zenith.
inline constexpr float pit_rim_degrees = 50;
inline constexpr float pit_radius_m = 1, pit_floor_radius_m = 0.05f;

// Nothing moves. Objects "floor", with apertures, and "cone", without; one light of 10 degrees, partly behind the rim.
Scene make_conical_pit();

}  // namespace lamina
