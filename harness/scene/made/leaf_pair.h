// SPDX-License-Identifier: Apache-2.0
// The built-in scene `leaf_pair`: two leaves, one partly behind the other, with the sun behind both. Where they overlap the
// light passes both, and the air between them is nobody's.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// Nothing moves. Objects "near_leaf" and "far_leaf", up to 0.8 mm thick; light "sun" casts.
Scene make_leaf_pair();

}  // namespace lamina
