// SPDX-License-Identifier: Apache-2.0
// Which share of scattered light goes into a direction, a steradian; `cosine` is 1 towards the sun, where light goes straight on.
// Haze has Henyey and Greenstein's, with the misprint (1 - g)^2 in place of 1 - g^2 where MISPRINTED_PHASE is defined.
#include "../henyey_greenstein/henyey_greenstein.glsl"
#include "../rayleigh/rayleigh.glsl"

float haze_phase(float cosine, float g) {
#ifdef MISPRINTED_PHASE
  return misprinted_hg(g, cosine);
#else
  return stable_hg(g, cosine);
#endif
}
