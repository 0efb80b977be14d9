// SPDX-License-Identifier: Apache-2.0
// The built-in scene `glossy_floor`: a floor of three glossy strips, polished to matt, and a mirror's strip, with coloured
// columns that stand on it, balls that hang over it, and a tiled wall behind.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// Nothing moves. Objects "floor_0" to "floor_3", "wall", "column_0" to "column_3", "ball_0" to "ball_2"; lights "key" (casts)
// and "fill".
Scene make_glossy_floor();

}  // namespace lamina
