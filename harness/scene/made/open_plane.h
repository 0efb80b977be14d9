// SPDX-License-Identifier: Apache-2.0
// The built-in scene `open_plane`: a plane that nothing hides from the sky. Every aperture is the whole hemisphere, and every
// answer a closed form.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// Nothing moves. One object, "plane"; one light of 10 degrees, 40 degrees above the horizon.
Scene make_open_plane();

}  // namespace lamina
