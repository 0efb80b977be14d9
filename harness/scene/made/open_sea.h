// SPDX-License-Identifier: Apache-2.0
// The built-in scene `open_sea`: deep water from the eye to the horizon under a low sun, two buoys, and a rock with a tower.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// `time_s` moves the waves. Objects "water", "rock", "tower", "lamp", "buoy_0", "buoy_1" and "sky"; light "sun" (casts).
Scene make_open_sea(float time_s);

}  // namespace lamina
