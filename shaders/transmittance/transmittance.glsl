// SPDX-License-Identifier: Apache-2.0
// What passes a layer of an optical depth (Bouguer's law). Values below 1.2e-38 may be 0.

float exp_transmittance(float depth) { return exp(-depth); }
float exp2_transmittance(float depth) { return exp2(-1.44269504 * depth); }  // 1 / ln 2

// The first term alone, as fog of old hardware: 1 - x, not below 0.
float linear_transmittance(float depth) { return max(1.0 - depth, 0.0); }

// By the function that TRANSMITTANCE names.
#ifdef TRANSMITTANCE
float transmittance(float depth) { return TRANSMITTANCE(depth); }
#endif
