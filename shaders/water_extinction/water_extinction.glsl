// SPDX-License-Identifier: Apache-2.0
// The share of light that is left after two ways in water: down to a depth, at a cosine to the vertical in the water, and up along a
// way (Bouguer's law). `extinction`: of one channel, 1/m.
#ifndef WATER_EXTINCTION_GLSL
#define WATER_EXTINCTION_GLSL

float along_both_ways(float extinction, float depth_m, float way_m, float down_cosine) {
  return exp(-extinction * (depth_m / down_cosine + way_m));
}

#ifdef WATER_EXTINCTION
float way_by_way(float extinction, float depth_m, float way_m, float down_cosine) {
  return exp(-extinction * (depth_m / down_cosine)) * exp(-extinction * way_m);
}
// Of lengths as half floats hold them.
float of_half_lengths(float extinction, float depth_m, float way_m, float down_cosine) {
  vec2 lengths = unpackHalf2x16(packHalf2x16(vec2(depth_m, way_m)));
  return along_both_ways(extinction, lengths.x, lengths.y, down_cosine);
}
// As if light came straight down.
float straight_down(float extinction, float depth_m, float way_m, float down_cosine) { return exp(-extinction * (depth_m + way_m)); }

// By the function that WATER_EXTINCTION names.
float water_extinction(float extinction, float depth_m, float way_m, float down_cosine) {
  return WATER_EXTINCTION(extinction, depth_m, way_m, down_cosine);
}
#endif
#endif
