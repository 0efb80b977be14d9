// SPDX-License-Identifier: Apache-2.0
// The built-in scene `glass_drift`: a pane, a ring of rods and a ball of glass that drift before stripes, a pixel a second in a
// picture of 256 rows. A pattern of every second pixel changes colour at odd seconds and fits again at even ones.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// Any finite time. Glass: "pane", "spoke_0" to "spoke_7", "ball"; opaque as in glass_stack.
Scene make_glass_drift(float time_s);

}  // namespace lamina
