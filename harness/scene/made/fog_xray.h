// SPDX-License-Identifier: Apache-2.0
// The built-in scene `fog_xray`: a suitcase and what is in it as an X-ray shows it: hulls alone, thickness turned into colour
// by a ramp.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// The suitcase turns once in 12 s; any finite time. No object is solid.
Scene make_fog_xray(float time_s);

}  // namespace lamina
