// SPDX-License-Identifier: Apache-2.0
// The built-in scene `ear`: a thin, bent form over a thick round one, as an ear over a head, of one skin and lit from behind.
// The head stays dark where the ear glows.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// Nothing moves. Objects "ear" (2.8 mm thick in the middle) and "head"; lights "sun" (casts) and "fill".
Scene make_ear();

}  // namespace lamina
