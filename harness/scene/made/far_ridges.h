// SPDX-License-Identifier: Apache-2.0
// The built-in scene `far_ridges`: hills and mountain ranges from 500 m to 50 km away, one behind another, on a round earth
// under a sun that moves. What air does to the far is all there is to see.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// One object, "land", which looks west from the origin. A day takes 24 s of scene time: see day.h. The time is finite. Calls
// for the effect `atmosphere`.
Scene make_far_ridges(float time_s);

}  // namespace lamina
