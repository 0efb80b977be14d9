// SPDX-License-Identifier: Apache-2.0
// The built-in scene `fog_shaft`: the sun through the windows of `two_windows` lights the dust in the room. A beam is a hull of
// fog; the shadows of the windows' bars are holes in it.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// Nothing moves. Objects "room" and "boxes", and "beam_0", "bar_0", "rung_0", "rung_1" and so on for each window.
Scene make_fog_shaft();

}  // namespace lamina
