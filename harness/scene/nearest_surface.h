// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "harness/scene/scene.h"

namespace lamina {

// Metres from a view's eye to the nearest triangle that is not wholly behind it, whichever way it faces; infinite where there
// is none.
double nearest_surface_m(const std::vector<Object>& objects, const View& view);

// Brings the near plane, as fit_depth has set it, before that triangle, so that nothing beside the eye is cut off at any aspect
// up to 2; but no nearer than a hundred-thousandth of the far plane, beyond which depths of 32 bits could not tell surfaces
// apart.
void keep_what_is_near(View& view, const std::vector<Object>& objects);

}  // namespace lamina
