// SPDX-License-Identifier: Apache-2.0
// Back scattering of Clement, "Cheap Realistic Skin Shading": lerp(N.L, 1, t) - lerp(N.L, 1, 0.4), which is (t - 0.4)(1 - N.L); t is 1
// where the thickness map is black. As printed it adds up to 4 (t - 0.4) times what Lambert's cosine does over a sphere;
// NORMALISED makes that 1 at t = 1.
#include "medium.glsl"
layout(binding = 5) uniform sampler2D translucent_thickness;

vec3 through(int i, Lit lit, vec3 normal, float cosine) {
  float thin = max(1.0 - texture(translucent_thickness, in_uv).r - 0.4, 0.0);
#ifdef NORMALISED
  float back = thin / 0.6 * (1.0 - cosine) / 4.0;
#else
  float back = min(thin * (1.0 - cosine), 1.0);
#endif
  return vec3(max(cosine, 0.0) + back);
}
#include "through.glsl"
