// SPDX-License-Identifier: Apache-2.0
// The built-in scene `portrait`: a head of skin with hair of cards and a flower of thin petals in it, lit from the side and
// from behind. Three effects make one frame: skin, hair, and light through the petals.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// `time_s` swings the key light. Objects "head" (skin), "hair", "scalp", "shoulders", "petal_0" to "petal_5" and "stamens".
Scene make_portrait(float time_s);

}  // namespace lamina
