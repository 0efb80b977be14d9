// SPDX-License-Identifier: Apache-2.0
// Which share of scattered light goes into a direction, a steradian, by haze of mean cosine g: Henyey and Greenstein, "Diffuse
// Radiation in the Galaxy", Astrophysical Journal 93, 1941. The cosine is 1 where light goes straight on.
#ifndef HENYEY_GREENSTEIN_GLSL
#define HENYEY_GREENSTEIN_GLSL

// 1 + g^2 - 2 g cosine, whose terms cancel near the peak, as a sum of what is not negative.
float phase_base(float g, float cosine) {
  float size = abs(g), from_peak = 1.0 - (g < 0.0 ? -cosine : cosine);
  return (1.0 - size) * (1.0 - size) + 2.0 * size * from_peak;
}

float stable_hg(float g, float cosine) {
  float base = phase_base(g, cosine);
  return 0.0795774715 * (1.0 - g) * (1.0 + g) / (base * sqrt(base));  // 1 / (4 pi)
}

// As it is printed.
float naive_hg(float g, float cosine) { return 0.0795774715 * (1.0 - g * g) / pow(1.0 + g * g - 2.0 * g * cosine, 1.5); }

// With (1 - g)^2 for 1 - g^2, as copies of Hoffman and Preetham's slides have it: integrates to (1 - g) / (1 + g) for g above 0.
float misprinted_hg(float g, float cosine) {
  float base = phase_base(g, cosine);
  return 0.0795774715 * (1.0 - g) * (1.0 - g) / (base * sqrt(base));
}

// An ellipse in place of it (Blasi, Le Saec and Schlick, "A Rendering Algorithm for Discrete Volume Density Objects", Computer
// Graphics Forum 12, 1993), with the mean cosine matched by k = 1.55 g - 0.55 g^3.
float schlick_phase(float g, float cosine) {
  float k = g * (1.55 - 0.55 * g * g), base = 1.0 - k * cosine;
  return 0.0795774715 * (1.0 - k * k) / (base * base);
}
#endif

// By the function that HENYEY_GREENSTEIN names.
#ifdef HENYEY_GREENSTEIN
float henyey_greenstein(float g, float cosine) { return HENYEY_GREENSTEIN(g, cosine); }
#endif
