// SPDX-License-Identifier: Apache-2.0
// The built-in scene `two_windows`: the inside of a room that light enters through two windows. What its walls see of the sky
// is two pieces far apart, which one aperture must stand for.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// The inside, its two windows in the wall z = 0 and their openings, in metres; the room is centred on x = 0 and its floor is
// y = 0.
inline constexpr glm::vec3 room_low{-2.5f, 0, 0}, room_high{2.5f, 2.7f, 4};
inline constexpr glm::vec2 window_low[2] = {{-1.85f, 0.85f}, {0.65f, 0.85f}},
                           window_high[2] = {{-0.65f, 2.25f}, {1.85f, 2.25f}};

// Nothing moves. Objects "room" and "boxes".
Scene make_two_windows();

}  // namespace lamina
