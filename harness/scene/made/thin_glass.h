// SPDX-License-Identifier: Apache-2.0
// The built-in scene `thin_glass`: rods of coloured glass, about a pixel wide in a picture of 256 rows, at slopes from level to
// upright, before stripes with hard edges. A pattern of pixels may miss all of a rod.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// Nothing moves. Glass: "rod_0" to "rod_12" from level to upright, "wide_rod_0" to "wide_rod_3"; opaque as in glass_stack.
Scene make_thin_glass();

}  // namespace lamina
