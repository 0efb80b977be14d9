// SPDX-License-Identifier: Apache-2.0
// The built-in scene `wax_block`: a block of wax with a square hole through it and a wax ball, lit from behind. One depth map
// of the light takes the hole for wax.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// Nothing moves. Objects "block" (10 x 8 x 5 cm, its hole along z) and "ball" (radius 3 cm); lights "lamp" (casts) and "fill".
Scene make_wax_block();

}  // namespace lamina
