// SPDX-License-Identifier: Apache-2.0
// The built-in scene `beach`: sand that runs from a dry shore down to deep water, with waves that fade towards it, foam at its
// edge, and rocks and posts half in the water, under a low sun.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// `time_s` moves the waves. Objects "water", "sand", "rock_0" to "rock_3", "post_0" to "post_2" and "sky"; light "sun" (casts).
Scene make_beach(float time_s);

}  // namespace lamina
