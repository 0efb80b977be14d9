// SPDX-License-Identifier: Apache-2.0
// The maps of Clement's layers where a scene gives none, made of the albedo by plain operations on colours, as his slides
// suggest. With his weights of .5, .3 and .2 the three of them sum to the albedo where light is full.
#pragma once

#include "harness/scene/effect_values.h"

namespace lamina {

// Half as wide as the albedo, paler and yellower: albedo times (.9, 1.1, 1.15), at most 1.
Texture epidermal_map(const EffectValues& so_far);
// An eighth as wide, redder: albedo times (1.15, .85, .775).
Texture subdermal_map(const EffectValues& so_far);

}  // namespace lamina
