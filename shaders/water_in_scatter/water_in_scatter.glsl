// SPDX-License-Identifier: Apache-2.0
// Sunlight that water scatters once towards an eye above it, from a way of `distance_m` under a level surface, for a sunlight, a
// scattering coefficient and a phase function of 1: (1 - e^-kd) / k, k = c (1 + view_cosine / sun_cosine), with the extinction c
// and the cosines of both ways to the vertical in the water.
#ifndef WATER_IN_SCATTER_GLSL
#define WATER_IN_SCATTER_GLSL
#include "../mean_transmittance/mean_transmittance.glsl"

float closed_in_scatter(float extinction, float distance_m, float view_cosine, float sun_cosine) {
  return distance_m * stable_mean(extinction * (1.0 + view_cosine / sun_cosine) * distance_m);
}

// A function that artists fit: it saturates as an exponential of the view's way alone, by the extinction of a sun straight above
// and a view straight down.
float fitted_in_scatter(float extinction, float distance_m, float view_cosine, float sun_cosine) {
  return distance_m * stable_mean(2.0 * extinction * distance_m);
}

#ifdef WATER_IN_SCATTER
// As it is written.
float naive_in_scatter(float extinction, float distance_m, float view_cosine, float sun_cosine) {
  float k = extinction * (1.0 + view_cosine / sun_cosine);
  return (1.0 - exp(-k * distance_m)) / k;
}

// By the function that WATER_IN_SCATTER names.
float water_in_scatter(float extinction, float distance_m, float view_cosine, float sun_cosine) {
  return WATER_IN_SCATTER(extinction, distance_m, view_cosine, sun_cosine);
}
#endif
#endif
