// SPDX-License-Identifier: Apache-2.0
// The built-in scene `fog_heart`: the beating heart in four hulls of fog, two of them nested and two crossing each other.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// Any finite time: the heart beats, and the crossing hulls turn around it once in 20 s. Objects "heart", "outer", "inner",
// "left" and "right".
Scene make_fog_heart(float time_s);

}  // namespace lamina
