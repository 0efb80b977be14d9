// SPDX-License-Identifier: Apache-2.0
// The built-in scene `valley`: the mountain valley of `terrain`, lit through its apertures, with the lake of fog of
// `fog_valley` in it, under the air of a hazy day. Three effects make one frame: aperture lighting, fog, atmosphere.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// The day and the waves of the fog are those of `fog_valley`. Objects "terrain" and "fog"; light "sun".
Scene make_valley(float time_s);

}  // namespace lamina
