// SPDX-License-Identifier: Apache-2.0
// Kelemen and Szirmay-Kalos' reflection times N.L, after d'Eon and Luebke (GPU Gems 3, chapter 14, listing 14-2), of cosines:
// lv is L.V. h = L + V has the length sqrt(2 + 2 lv), so that nothing is normalised; opposite directions reflect nothing.
#ifndef KELEMEN_BY_COSINES_GLSL
#define KELEMEN_BY_COSINES_GLSL
#include "../beckmann/beckmann_without_angles.glsl"

float kelemen_by_cosines(float nl, float nv, float lv, float m) {
  float squared = max(2.0 + 2.0 * lv, 1e-7), length_h = sqrt(squared);
  float base = 1.0 - 0.5 * length_h, twice = base * base;
  float fresnel = 0.028 + 0.972 * twice * twice * base;
  return max(nl, 0.0) * fresnel * beckmann_without_angles((nl + nv) / length_h, m) / squared;
}
#endif
