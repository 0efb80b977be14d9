// SPDX-License-Identifier: Apache-2.0
// The built-in scene `terrain`: a mountain valley under a sun that moves, for soft shadows of a whole landscape. After Oat and
// Sander, "Ambient Aperture Lighting", I3D 2007, whose terrain it is to be held against.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// A day takes 24 s of scene time and starts in the morning: see day.h. The time is finite.
Scene make_terrain(float time_s);

}  // namespace lamina
