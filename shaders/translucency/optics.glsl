// SPDX-License-Identifier: Apache-2.0
// Light at a smooth boundary between air and a medium, and what a half-space of the medium sends back.
// eta: index of refraction of the inside over that of the outside, 1 or more. Cosines are to the normal, 0 to 1.
#ifndef TRANSLUCENCY_OPTICS_GLSL
#define TRANSLUCENCY_OPTICS_GLSL
#include "../fresnel/exact_fresnel.glsl"
#include "../wrap_lighting/normalised_wrap.glsl"

const float pi = 3.14159265;
const float min_cosine = 1e-3;

// Cosine inside of light that comes from outside at `cosine` (Snell).
float refracted_cosine(float cosine, float eta) { return sqrt(max(1.0 - (1.0 - cosine * cosine) / (eta * eta), 0.0)); }

// Share of unpolarized light that the boundary reflects (Fresnel). With eta = 1 there is no boundary.
float fresnel(float cosine, float eta) { return exact_fresnel(cosine, eta); }

// What a half-space of albedo `albedo` (scattering over extinction, isotropic) reflects of diffuse light: Jensen, Marschner,
// Levoy and Hanrahan, "A Practical Model for Subsurface Light Transport", SIGGRAPH 2001 (the dipole's total, and the
// polynomial for the mean internal reflection).
vec3 diffuse_reflectance(vec3 albedo, float eta) {
  float inside = -1.440 / (eta * eta) + 0.710 / eta + 0.668 + 0.0636 * eta;
  float a = (1.0 + inside) / (1.0 - inside);
  vec3 root = sqrt(3.0 * (1.0 - albedo));
  return 0.5 * albedo * (1.0 + exp(-4.0 / 3.0 * a * root)) * exp(-root);
}

// The same, of light scattered once, lit and seen along the normal; as a Lambert albedo (Hanrahan and Krueger, "Reflection from
// Layered Surfaces due to Subsurface Scattering", SIGGRAPH 1993).
vec3 single_reflectance(vec3 albedo, float eta) {
  float through = (1.0 - fresnel(1.0, eta)) / eta;
  return albedo * (through * through / 8.0);
}

// Share of diffuse light that comes through a slab of this optical depth (thickness times extinction), for a half-space that
// reflects `reflectance`, over that reflectance: Christensen and Burley, "Approximate Reflectance Profiles for Efficient
// Subsurface Scattering", Pixar 2015: the profile, and its width for diffuse light, integrated over a plane at this depth.
vec3 slab_transmittance(vec3 optical_depth, vec3 reflectance) {
  vec3 beyond = reflectance - 0.8;
  vec3 x = optical_depth * (1.9 - reflectance + 3.5 * beyond * beyond);
  return 0.25 * exp(-x) + 0.75 * exp(-x / 3.0);
}

// Lambert's cosine wrapped around the edge; over the sphere it adds up to what Lambert's does.
float wrapped_cosine(float cosine, float wrap) { return normalised_wrap(cosine, wrap); }

#endif
