// SPDX-License-Identifier: Apache-2.0
// The built-in scene `skin_spheres`: balls of skin of 5 and 10 mm radius, lit from the side. What light does there is a closed
// form: on a sphere each Gaussian of the profile is a spherical one.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// Nothing moves. Objects "small" and "large", white and without highlights; light "lamp".
Scene make_skin_spheres();

}  // namespace lamina
