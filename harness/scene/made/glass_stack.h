// SPDX-License-Identifier: Apache-2.0
// The built-in scene `glass_stack`: coloured panes one behind the other, a ball and a bowl of glass, before stripes with hard
// edges. Rays cross up to ten surfaces.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// Nothing moves. Glass: "red_pane", "green_pane", "blue_pane", "ball", "bowl"; opaque: "table", "dark_stripes",
// "light_stripes", "stone".
Scene make_glass_stack();

// What glass stands on and before, in scenes of glass: a table, and a wall of stripes 2.2 m wide at z = -1.1.
void add_striped_room(Scene& scene);

}  // namespace lamina
