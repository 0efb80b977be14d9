// SPDX-License-Identifier: Apache-2.0
// The built-in scene `fog_valley`: the mountain valley of `terrain` with a lake of fog in it, whose surface the slopes cut.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// The day of `terrain`; waves of fog pass every 24 s. Any finite time. Objects "terrain" and "fog".
Scene make_fog_valley(float time_s);

}  // namespace lamina
