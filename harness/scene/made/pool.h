// SPDX-License-Identifier: Apache-2.0
// The built-in scene `pool`: a swimming pool of coloured tiles under a low sun, with ladder posts and balls half in the water,
// a wall and columns to be reflected, and small waves.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// `time_s` moves the waves. Objects "water", "floor", "end_0", "end_1", "side_0", "side_1", "deck", "wall", "post_0", "post_1",
// "column_0" to "column_2", "ball_0" to "ball_2" and "sky"; light "sun" (casts).
Scene make_pool(float time_s);

}  // namespace lamina
