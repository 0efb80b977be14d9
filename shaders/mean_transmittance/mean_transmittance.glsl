// SPDX-License-Identifier: Apache-2.0
// The mean transmittance from the front of a layer to each of its points: what a segment of a ray scatters is this times its
// length. x is the layer's optical depth, 0 or more.
#ifndef MEAN_TRANSMITTANCE_GLSL
#define MEAN_TRANSMITTANCE_GLSL

// A series where the terms of 1 - e^-x cancel; the first term left out is below 2e-7.
float stable_mean(float x) {
  float series = 1.0 - x * (0.5 - x * (1.0 / 6.0 - x * (1.0 / 24.0 - x * (1.0 / 120.0 - x * (1.0 / 720.0 - x * (1.0 / 5040.0))))));
  return x < 0.5 ? series : (1.0 - exp(-x)) / x;
}

float naive_mean(float x) { return (1.0 - exp(-x)) / x; }

// Two terms below 0.01, as production engines have it for fog.
float switched_mean(float x) { return x < 0.01 ? 1.0 - 0.5 * x : (1.0 - exp(-x)) / x; }
#endif

// By the function that MEAN_TRANSMITTANCE names.
#ifdef MEAN_TRANSMITTANCE
float mean_transmittance(float depth) { return MEAN_TRANSMITTANCE(depth); }
#endif
