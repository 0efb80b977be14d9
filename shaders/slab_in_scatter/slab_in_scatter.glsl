// SPDX-License-Identifier: Apache-2.0
// Sunlight that a homogeneous slab scatters once to an eye at its bottom, for an irradiance above it and a phase function of 1:
// b e^-a (1 - e^-(b-a)) / (b - a), a the slab's optical depth along the sun's way and b along the ray (Chandrasekhar, "Radiative
// Transfer", 1950, first-order scattering).
#include "../mean_transmittance/mean_transmittance.glsl"

// The formula is the same with a and b exchanged in all but its first factor: so no exponential overflows.
float stable_slab(float sun_depth, float view_depth) {
  return view_depth * exp(-min(sun_depth, view_depth)) * stable_mean(abs(view_depth - sun_depth));
}

// (1 - e^-(b-a)) / (b - a) with its sign: e^(a-b) overflows where the sun's way is the longer one by far.
float one_sided_slab(float sun_depth, float view_depth) {
  float x = view_depth - sun_depth;
  return view_depth * exp(-sun_depth) * (abs(x) < 0.5 ? stable_mean(x) : (1.0 - exp(-x)) / x);
}

// As it is printed.
float naive_slab(float sun_depth, float view_depth) {
  return view_depth * (exp(-sun_depth) - exp(-view_depth)) / (view_depth - sun_depth);
}

// By the function that SLAB_IN_SCATTER names.
#ifdef SLAB_IN_SCATTER
float slab_in_scatter(float sun_depth, float view_depth) { return SLAB_IN_SCATTER(sun_depth, view_depth); }
#endif
