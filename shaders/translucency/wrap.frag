// SPDX-License-Identifier: Apache-2.0
// Wrap lighting alone: Green, "Real-Time Animated Translucency", GDC 2004. As printed it adds up to 1 + wrap times what Lambert's
// cosine does over a sphere; NORMALISED divides by that. SHIFT adds the chapter's red.
#include "medium.glsl"
#include "wrap_colour.glsl"

layout(constant_id = 0) const float shift_width = 0.3;
layout(constant_id = 1) const float shift_red = 0.15;

vec3 through(int i, Lit lit, vec3 normal, float cosine) {
#ifdef NORMALISED
  return vec3(wrapped_cosine(cosine, wrap));
#else
  float wrapped = max(cosine + wrap, 0.0) / (1.0 + wrap);
#ifdef SHIFT
  return with_shift(wrapped, shift_width, vec3(shift_red, 0.0, 0.0));
#else
  return vec3(wrapped);
#endif
#endif
}
#include "through.glsl"
