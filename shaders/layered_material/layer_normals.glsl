// SPDX-License-Identifier: Apache-2.0
// Layers below the outer one that have a normal map of their own. What arrives at such a layer is the light of its place without the map,
// blurred and shaded (layer_light.glsl). Where that is less than the smooth surface's light, the map's light is scaled by as much;
// where it is more, the rest is added: E = D(N) min(E' / D, 1) + max(E' - D, 0), D the light of the smooth normal, D(N)
// that of the map. Even light gives Lambert's law of the map, a flat map gives E', and nothing grows where D is near 0.
// The map is seen through the eye's disc, as the layer is: one fetch of means as wide as it, whose lack of length is how much the
// normals scatter (mean_normal.glsl).
// Needs footprints.glsl, one_fetch.glsl and mean_normal.glsl.

#ifdef INNER_NORMAL
layout(binding = 16) uniform sampler2D inner_normal;  // 1/2 + 1/2 of the mean of unit normals, as all of these
#endif
#ifdef LAYER_3_NORMAL
layout(binding = 17) uniform sampler2D layer_3_normal;
#endif
#ifdef LAYER_4_NORMAL
layout(binding = 18) uniform sampler2D layer_4_normal;
#endif
#ifdef LAYER_5_NORMAL
layout(binding = 19) uniform sampler2D layer_5_normal;
#endif
#ifdef LAYER_6_NORMAL
layout(binding = 20) uniform sampler2D layer_6_normal;
#endif

// `uv`, `radius`: where the eye sees the layer, and its disc, in texture coordinates.
vec3 bumped_light(vec3 arriving, sampler2D normals, vec2 uv, vec2 radius, SurfacePoint point, Footprint footprint) {
  vec3 mean = one_fetch_disc(normals, uv, radius, footprint).rgb * 2.0 - 1.0;
  vec3 of_map = mean_diffuse_light(point.world_from_tangent * mean, point.position);
  vec3 of_surface = diffuse_light(point.normal, point.position);
  return of_map * min(arriving / max(of_surface, vec3(1e-6)), vec3(1.0)) + max(arriving - of_surface, vec3(0.0));
}
