// SPDX-License-Identifier: Apache-2.0
// Strands of hair as textures for cards: four clumps side by side, from root (top) to tip.
#pragma once

#include "harness/scene/textures.h"

namespace lamina {

inline constexpr uint32_t strand_clumps = 4;  // the first is dense and dark, for the layers next to the skin

struct StrandTextures {
  Texels albedo;     // linear colour; alpha = how much of the texel strands cover
  Texels direction;  // red, green = 1/2 + 1/2 (cos 2a, sin 2a), a = the strand's angle from dP/du towards dP/dv
};

// 256 x 512 texels, the same on every machine. `colour`: linear, of a strand in the mean. `card_m`: a card's width and length,
// for the angles.
StrandTextures strand_textures(glm::vec3 colour, glm::vec2 card_m);

}  // namespace lamina
