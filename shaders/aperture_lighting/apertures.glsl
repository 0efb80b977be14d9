// SPDX-License-Identifier: Apache-2.0
// The apertures of the point that a fragment shades: xyz = unit direction, world; w = angular radius in radians. From the vertices, or
// from maps over the unwrap; interpolated either way, so made unit again.
#ifdef APERTURE_MAP
layout(binding = 5) uniform sampler2D aperture_0;
#if APERTURES > 1
layout(binding = 6) uniform sampler2D aperture_1;
#endif
#if APERTURES > 2
layout(binding = 7) uniform sampler2D aperture_2;
#endif
#if APERTURES > 3
layout(binding = 8) uniform sampler2D aperture_3;
#endif
#else
layout(location = 4) in vec4 in_aperture[APERTURES];
#endif

// Unit length, or `otherwise` where v has none.
vec3 unit_or(vec3 v, vec3 otherwise) {
  float squared = dot(v, v);
  return squared > 1e-12 && squared < 1e12 ? v * inversesqrt(squared) : otherwise;
}

#ifdef APERTURE_CHOICE
// How much the cap of what is blocked counts, 0 to 1: its direction's length says it.
float blocked_weight(vec4 interpolated) { return clamp((length(interpolated.xyz) - 0.0625) / 0.9375, 0.0, 1.0); }
#endif
#ifdef SOFT_APERTURE
// Half the angle over which an aperture fades, in radians: 1 / (1 + it) is its direction's length.
float edge_angle(vec4 interpolated) { return clamp(1.0 / max(length(interpolated.xyz), 0.5) - 1.0, 0.0, 1.0); }
#endif

vec4 aperture_of_point(vec4 interpolated, vec3 normal) {
  return vec4(unit_or(interpolated.xyz, normal), max(interpolated.w, 0.0));
}

// As they are kept.
vec4 kept_aperture(int i, vec2 uv) {
#ifdef APERTURE_MAP
#if APERTURES > 1
  if (i == 1) return texture(aperture_1, uv);
#endif
  return texture(aperture_0, uv);
#else
  return in_aperture[i];
#endif
}

void read_apertures(vec2 uv, vec3 normal, out vec4 apertures[APERTURES]) {
#ifdef APERTURE_MAP
  apertures[0] = aperture_of_point(texture(aperture_0, uv), normal);
#if APERTURES > 1
  apertures[1] = aperture_of_point(texture(aperture_1, uv), normal);
#endif
#if APERTURES > 2
  apertures[2] = aperture_of_point(texture(aperture_2, uv), normal);
#endif
#if APERTURES > 3
  apertures[3] = aperture_of_point(texture(aperture_3, uv), normal);
#endif
#else
  for (int i = 0; i < APERTURES; ++i) apertures[i] = aperture_of_point(in_aperture[i], normal);
#endif
}
