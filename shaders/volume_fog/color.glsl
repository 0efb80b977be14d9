// SPDX-License-Identifier: Apache-2.0
// From thickness to colour. Linear light; premultiplied: what is drawn is color + (1 - alpha) * frame. With TABLE the exponential
// is read from a table of opacity over optical thickness, evenly from 0 to TABLE_END.
#include "fog_numbers.glsl"
layout(binding = 4) uniform sampler2D fog_color;
#ifdef RAMP
layout(binding = 5) uniform sampler2D ramp;
#elif defined(TABLE)
layout(binding = 5) uniform sampler2D opacity_table;
#endif

// A place along a table of this width, in texture coordinates: `part` 0 is the first texel's centre, 1 and beyond the last one's.
float along(float part, int width) {
  float texels = float(width);
  return (clamp(part, 0.0, 1.0) * (texels - 1.0) + 0.5) / texels;
}

// `thickness`: metres along the ray, weighted by the hulls' shares; 0 or more.
vec4 fog_of(float thickness) {
#ifdef RAMP
  vec4 color = textureLod(ramp, vec2(along(thickness / ramp_length, textureSize(ramp, 0).x), 0.5), 0.0);
  return density > 0.0 ? vec4(color.rgb * color.a, color.a) : vec4(0.0);  // no fog, whatever the ramp says
#else
  // Single scattering under even light (Hoffman and Preetham, "Rendering Outdoor Light Scattering in Real Time", GDC 2002).
#ifdef TABLE
  float at = along(density * thickness / TABLE_END, textureSize(opacity_table, 0).x);
  float opacity = textureLod(opacity_table, vec2(at, 0.5), 0.0).r;
#else
  float opacity = 1.0 - exp(-density * thickness);
#endif
  return vec4(texelFetch(fog_color, ivec2(0), 0).rgb * opacity, opacity);
#endif
}
