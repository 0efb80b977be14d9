// SPDX-License-Identifier: Apache-2.0
// Henyey and Greenstein's phase function with the polarized factor 1 + cos^2 of small particles: Cornette and Shanks, "Physically
// Reasonable Analytic Expression for the Single-Scattering Phase Function", Applied Optics 31, 1992. Its mean cosine is
// 3 g (4 + g^2) / (5 (2 + g^2)), not g.
#include "../henyey_greenstein/henyey_greenstein.glsl"

float stable_cornette_shanks(float g, float cosine) {
  float base = phase_base(g, cosine);
  return 0.119366207 * (1.0 - g) * (1.0 + g) * (1.0 + cosine * cosine) / ((2.0 + g * g) * base * sqrt(base));  // 3 / (8 pi)
}

// As it is printed.
float naive_cornette_shanks(float g, float cosine) {
  return 0.119366207 * (1.0 - g * g) / (2.0 + g * g) * (1.0 + cosine * cosine) / pow(1.0 + g * g - 2.0 * g * cosine, 1.5);
}

// What programs that name the one and compute the other give.
float hg_for_cornette_shanks(float g, float cosine) { return stable_hg(g, cosine); }

// Its limit for small particles, g = 0.
float rayleigh_for_cornette_shanks(float g, float cosine) { return 0.0596831037 * (1.0 + cosine * cosine); }  // 3 / (16 pi)

// By the function that CORNETTE_SHANKS names.
#ifdef CORNETTE_SHANKS
float cornette_shanks(float g, float cosine) { return CORNETTE_SHANKS(g, cosine); }
#endif
