// SPDX-License-Identifier: Apache-2.0
// The share of light that the surface reflects. FRESNEL: exact_share, schlick_share, rough_share. `index`: of the side behind over that
// of the eye; `lost`: variance of the slopes, an axis, that the normal does not show.
#define exact_share 0
#define schlick_share 1
#define rough_share 2
#if FRESNEL == schlick_share
#include "fresnel/schlick_both_sides.glsl"
#endif

float reflected_share(float cosine, float index, float lost) {
#if FRESNEL == schlick_share
  return index < 1.0 && cosine * cosine < 1.0 - index * index ? 1.0 : schlick_both_sides(cosine, index);
#elif FRESNEL == rough_share
  // Bruneton, Neyret and Holzschuch, "Real-time Realistic Ocean Lighting using Seamless Transitions from Geometry to BRDF",
  // Eurographics 2010: a fit to the mean over facets of a Gaussian, for light from above.
  float normal = (index - 1.0) / (index + 1.0), f0 = normal * normal, deviation = sqrt(max(lost, 0.0));
  float fitted = f0 + (1.0 - f0) * pow(1.0 - cosine, 5.0 * exp(-2.69 * deviation)) / (1.0 + 22.7 * deviation * sqrt(deviation));
  // Where nothing is lost it is Schlick's: the exact share in its place.
  float flat_fit = f0 + (1.0 - f0) * pow(1.0 - cosine, 5.0);
  return index < 1.0 ? exact_fresnel(cosine, index) : clamp(exact_fresnel(cosine, index) * fitted / flat_fit, 0.0, 1.0);
#else
  return exact_fresnel(cosine, index);
#endif
}
