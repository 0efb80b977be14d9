// SPDX-License-Identifier: Apache-2.0
// The built-in scene `heart_in_fog`: the beating heart over a stone floor, sunk into a bank of fog that lies on it, with a veil
// of thin fog all around and the light behind. Two effects make one frame: layers under fog.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// Any finite time: the heart beats, and waves run over the bank. Objects "heart", "floor", "bank" and "veil".
Scene make_heart_in_fog(float time_s);

}  // namespace lamina
