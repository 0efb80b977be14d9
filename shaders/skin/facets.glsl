// SPDX-License-Identifier: Apache-2.0
// What a highlight depends on. All reflections below leave out 1/pi, as diffuse light does: a surface of `specular` 1 reflects
// what a smooth one does.
#ifndef FACETS_GLSL
#define FACETS_GLSL
#include "../beckmann/beckmann_without_angles.glsl"

struct Facets {
  float nl, nv, nh, hv;  // cosines; h is half-way between L and V
  float squared;         // (L + V)^2
  float m;               // slope of microfacets
  float f0;              // reflectance straight on
};

Facets facets_of(vec3 normal, vec3 to_light, vec3 to_eye, float m, float f0) {
  vec3 h = to_light + to_eye;
  float squared = max(dot(h, h), 1e-6), short_h = inversesqrt(squared);
  return Facets(clamp(dot(normal, to_light), 0.0, 1.0), clamp(dot(normal, to_eye), 0.0, 1.0),
                clamp(dot(normal, h) * short_h, 0.0, 1.0), clamp(dot(to_eye, h) * short_h, 0.0, 1.0), squared, m, f0);
}

float schlick(float cosine, float f0) {
  float base = 1.0 - cosine, squared = base * base;
  return f0 + (1.0 - f0) * squared * squared * base;
}

#endif
