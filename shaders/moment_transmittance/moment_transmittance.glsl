// SPDX-License-Identifier: Apache-2.0
// What reaches the eye from a depth behind one or two layers, from four power moments of their absorbance: the solution of the
// Hankel system, whose matrix has a rank of as many as there are layers.
#include "../transparency/moments.glsl"

// Layers at the depths z0 and z1 (-1 to 1) share the absorbance `total`: `share` of it is z0's. `z`: the depth that asks.
float of_two_layers(float z0, float z1, float share, float total, float z, float bias) {
  float rest = 1.0 - share, s0 = z0 * z0, s1 = z1 * z1;
  vec4 moments = share * vec4(z0, s0, s0 * z0, s0 * s0) + rest * vec4(z1, s1, s1 * z1, s1 * s1);
  return moment_transmittance(total, moments, z, bias, 0.25);
}

float bias_5e_5(float z0, float z1, float share, float total, float z) { return of_two_layers(z0, z1, share, total, z, 5e-5); }
float bias_5e_4(float z0, float z1, float share, float total, float z) { return of_two_layers(z0, z1, share, total, z, 5e-4); }
float bias_5e_3(float z0, float z1, float share, float total, float z) { return of_two_layers(z0, z1, share, total, z, 5e-3); }
// What the paper names for single precision.
float bias_5e_7(float z0, float z1, float share, float total, float z) { return of_two_layers(z0, z1, share, total, z, 5e-7); }
float unbiased_moments(float z0, float z1, float share, float total, float z) { return of_two_layers(z0, z1, share, total, z, 0.0); }

// By the function that MOMENT_TRANSMITTANCE names.
#ifdef MOMENT_TRANSMITTANCE
float transmittance_by_moments(float z0, float z1, float share, float total, float z) {
  return MOMENT_TRANSMITTANCE(z0, z1, share, total, z);
}
#endif
