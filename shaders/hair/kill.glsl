// SPDX-License-Identifier: Apache-2.0
// Which fragments of a card are killed: those whose opacity is below a threshold in (0, 1), by the function that THRESHOLD names.
//
//   same_bayer       the seed's: one 4x4 pattern for all cards (Bayer 1973), so cards over each other hide alike
//   same_gradient    one interleaved gradient noise for all cards (Jimenez, SIGGRAPH 2014)
//   golden_gradient  that noise, moved on by the golden ratio from card to card
//   golden_bayer     the pattern, moved on by the golden ratio
//   lattice          the pattern's ranks in another order for each card
//   white            a number of its own for each pixel and card
//   hashed           noise that sticks to the card (Wyman and McGuire, "Hashed Alpha Testing", I3D 2017)
//   cutoff           the same threshold everywhere: plain alpha test
//
// OPACITY is the sampler whose alpha counts.
#include "dither/dither.glsl"

layout(binding = 4) uniform sampler2D OPACITY;

float next_card(float pattern, float card) { return fract(pattern + card * 0.618034); }

float same_bayer(ivec2 pixel, float card, vec3 place) { return bayer_4x4(pixel); }
float same_gradient(ivec2 pixel, float card, vec3 place) { return gradient_noise(vec2(pixel)); }
float golden_gradient(ivec2 pixel, float card, vec3 place) { return next_card(gradient_noise(vec2(pixel)), card); }
float golden_bayer(ivec2 pixel, float card, vec3 place) { return next_card(bayer_4x4(pixel), card); }
float lattice(ivec2 pixel, float card, vec3 place) { return lattice_4x4(pixel, uint(card), white_noise(uvec3(pixel >> 2, uint(card)))); }
float white(ivec2 pixel, float card, vec3 place) { return white_noise(uvec3(pixel, uint(card))); }
float hashed(ivec2 pixel, float card, vec3 place) { return hashed_threshold(place, max(length(dFdx(place)), length(dFdy(place)))); }
#ifdef CUTOFF
float cutoff(ivec2 pixel, float card, vec3 place) { return CUTOFF; }
#endif

// Below this nothing is there: a threshold of 0 must not paint empty texels.
const float least_opacity = 1.0 / 255.0;

bool killed(float opacity, ivec2 pixel, float card, vec3 place) {
#ifdef SOLID
  return false;
#else
  return opacity < max(THRESHOLD(pixel, card, place), least_opacity);
#endif
}
