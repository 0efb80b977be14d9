// SPDX-License-Identifier: Apache-2.0
// Which share of scattered light goes into a direction, a steradian; `cosine` is 1 towards the sun, where light goes straight on.
// haze_phase() is Henyey and Greenstein's ("Diffuse Radiation in the Galaxy", Astrophysical Journal 93, 1941), with the misprint
// (1 - g)^2 in place of 1 - g^2 where MISPRINTED_PHASE is defined.

float rayleigh_phase(float cosine) { return 0.0596831037 * (1.0 + cosine * cosine); }  // 3 / (16 pi)

float haze_phase(float cosine, float g) {
  // 1 + g^2 - 2 g cosine, without its cancellation.
  float base = (1.0 - g) * (1.0 - g) + 2.0 * g * (1.0 - cosine);
#ifdef MISPRINTED_PHASE
  float share = (1.0 - g) * (1.0 - g);
#else
  float share = (1.0 - g) * (1.0 + g);
#endif
  return 0.0795774715 * share / (base * sqrt(base));  // 1 / (4 pi)
}
