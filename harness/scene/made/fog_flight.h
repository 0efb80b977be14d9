// SPDX-License-Identifier: Apache-2.0
// The built-in scene `fog_flight`: a flight through banks of fog between columns. The eye passes in and out of hulls.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// A flight takes 10 s of scene time and begins again; any finite time. Objects "ground", "columns" and "bank_0" to "bank_8".
Scene make_fog_flight(float time_s);

}  // namespace lamina
