// SPDX-License-Identifier: Apache-2.0
// The baker `strands`: what passes over cards know of a whole card, and a texture whose mips keep their coverage.
//
// Buffer `Strands`: vec4[1 + vertices]. [0] xyz = the middle of the object, w = number of cards; [1 + vertex] xyz = the
// strand's direction in object space, w = its card's number. Texture `hair_albedo_kept`: hair_albedo for an alpha test at 1/2.
#pragma once

#include "harness/manifest/effect_code.h"

namespace lamina {

extern const BakerCode strand_baker;

}  // namespace lamina
