// SPDX-License-Identifier: Apache-2.0
// How far a refracted ray from the surface lands on a bottom. `view_cosine`: of the ray from the eye to the vertical, at the
// surface; `depth_m`: of what stands behind the pixel, unrefracted; `index`: of the water over the air. Metres from the surface's
// point, along the level.
#ifndef REFRACTION_WAY_GLSL
#define REFRACTION_WAY_GLSL

// Down to the depth: exact over level bottoms.
float way_to_depth(float refracted_down, float depth_m) { return depth_m / max(refracted_down, 0.2); }

#ifdef REFRACTION_WAY
float refracted_cosine(float view_cosine, float index) { return sqrt(1.0 - (1.0 - view_cosine * view_cosine) / (index * index)); }
float down_to_depth(float view_cosine, float depth_m, float index) {
  float c = refracted_cosine(view_cosine, index);
  return way_to_depth(c, depth_m) * sqrt(1.0 - c * c);
}
// As long as the unrefracted way.
float as_long(float view_cosine, float depth_m, float index) {
  float c = refracted_cosine(view_cosine, index);
  return depth_m / view_cosine * sqrt(1.0 - c * c);
}
float unrefracted(float view_cosine, float depth_m, float index) {
  return depth_m / view_cosine * sqrt(1.0 - view_cosine * view_cosine);
}

// By the function that REFRACTION_WAY names.
float refraction_way(float view_cosine, float depth_m, float index) { return REFRACTION_WAY(view_cosine, depth_m, index); }
#endif
#endif
