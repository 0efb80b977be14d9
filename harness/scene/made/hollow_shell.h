// SPDX-License-Identifier: Apache-2.0
// The built-in scene `hollow_shell`: a ball of glassy wax with a round hole inside that nobody sees, under several lights that
// cast. One depth map takes it for solid: five times as thick as it is.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// Nothing moves. Object "shell" (radius 5 cm, its hole 4 cm); lights "back" and "side" and the point light "lamp" all cast.
Scene make_hollow_shell();

}  // namespace lamina
