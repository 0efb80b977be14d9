// SPDX-License-Identifier: Apache-2.0
// The built-in scenes `skin_head`, a head-like form of skin with pores, nose and ears under a lamp that swings around it, and
// `skin_tones`, three of them from pale to dark.
#pragma once

#include "harness/scene/scene.h"

namespace lamina {

// The lamp swings by 25 degrees to both sides, once in 2 pi seconds. Object "head"; lights "key" (casts), "rim" and "fill".
// Views: the whole face, a face 60 pixels high in 512 rows, the nose from near, an ear before the rim light.
Scene make_skin_head(float time_s);

// Objects "pale", "tan" and "dark".
Scene make_skin_tones(float time_s);

}  // namespace lamina
