// SPDX-License-Identifier: Apache-2.0
// The built-in scene `rough_glass`: panes of three roughnesses, and a thick one, before a tiled wall and coloured balls; a thin
// rod stands before the panes.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// Nothing moves. Objects "pane_0" to "pane_3", "wall", "floor", "ball_0" to "ball_3" and "rod"; lights "key" (casts) and
// "fill".
Scene make_rough_glass();

}  // namespace lamina
