// SPDX-License-Identifier: Apache-2.0
// The built-in scene `skin_plate`: a plate of skin with bumps, half of which lies in the shadow of a straight edge.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// Nothing moves. Objects "plate" (40 mm wide, with bumps of 2.5 mm) and "edge", which hides the light from its left half; light
// "lamp".
Scene make_skin_plate();

}  // namespace lamina
