// SPDX-License-Identifier: Apache-2.0
// The built-in scene `hair_head`: a head with hair of cards, combed back and lit from the side and from behind.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// Nothing moves. Objects "hair" (650 cards of 12 quads), "head", "scalp", "neck" and "shoulders"; lights "key" (casts), "rim"
// and "fill".
Scene make_hair_head();

}  // namespace lamina
