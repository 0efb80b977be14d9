// SPDX-License-Identifier: Apache-2.0
// The layered material on screen. One of these definitions says where the light comes from:
//   LIGHT_FROM_MAP     all layers from the light map, below the surface blurred by the depth (Oat 2006, listing 3)
//   LIGHT_FROM_TAPS    outer: N.L of the mapped normal; inner: the mean of N.L over 13 taps of the normal map (section 4.6, first
//                      optimization; the lighting terms are averaged, never the normals)
//   LIGHT_FROM_VERTEX  outer: N.L of the mapped normal; inner: N.L of the vertex normal (section 4.6, second optimization)
//   LIGHT_FROM_MEAN    all layers by the mean of the normals and by how much they scatter (mean_normal.glsl)
// and others how layers are filtered and shaded:
//   LIGHT_FILTER, BASE_FILTER  what takes the place of the 13 taps, a function of (sampler, center, radius, footprint): poisson_disc,
//                              golden_disc, ring_disc, merged_disc, one_fetch_disc, one_fetch_thirteen
//   LIGHT_COVERED      the light map is not filled beyond its charts: its alpha is how much of a texel they cover, by which light is
//                      divided; where layers shade, the outer one's transparency is then fetched
//   BASE_BLURRED       the inner layer is read from maps that were blurred once (blurred_base.glsl)
//   SHADOWS_...        see layer_light.glsl; without any, the 13 taps of a map are shadowed each, other filters by their means, and
//                      what has no map at the center
#include "../common/frame.glsl"
#include "../common/surface.glsl"
#include "../common/mesh_in.glsl"
#include "../common/extra_fetches.glsl"
#include "layers.glsl"
#include "poisson_disc.glsl"
#include "footprints.glsl"
#include "one_fetch.glsl"
#include "ring_disc.glsl"
#include "golden_disc.glsl"
#include "merged_disc.glsl"
#if defined(BASE_BLURRED) && defined(LAYER_DEPTH)
#include "blurred_base.glsl"
#endif
#if !defined(SHADOWS_AT_CENTER) && !defined(SHADOWS_LEFT_OUT) && !defined(SHADOWS_PREMULTIPLIED)
#if !defined(LIGHT_FROM_MAP) || defined(LIGHT_COVERED)
#define SHADOWS_AT_CENTER
#elif defined(LIGHT_FILTER)
#define SHADOWS_OF_MEANS
#else
#define SHADOWS_AT_TAPS
#endif
#endif
#ifndef LIGHT_FILTER
#define LIGHT_FILTER poisson_disc
#endif
#ifndef BASE_FILTER
#define BASE_FILTER poisson_disc
#endif

#ifdef LIGHT_FROM_MAP
layout(binding = 7) uniform sampler2D light_map;  // rgb irradiance; alpha = the outer layer's transparency, where layers shade
#endif
#if defined(INNER_NORMAL) || defined(LAYER_3_NORMAL) || defined(LAYER_4_NORMAL) || defined(LAYER_5_NORMAL) || defined(LAYER_6_NORMAL)
#define LAYER_NORMALS
#endif
#if defined(LIGHT_FROM_MEAN) || defined(LAYER_NORMALS)
#include "mean_normal.glsl"
#endif
#ifdef LAYER_NORMALS
#include "layer_normals.glsl"
#endif
#ifdef LIGHT_FROM_MEAN
layout(binding = 7) uniform sampler2D outer_normal_mean;  // 1/2 + 1/2 of the mean of unit normals
#endif
layout(location = 0) out vec4 out_color;

vec4 covered(vec4 light) {
#ifdef LIGHT_COVERED
  return vec4(light.rgb / max(light.a, 1e-3), 1.0);
#else
  return light;
#endif
}

#ifdef INNER_LAYER
#include "layer_light.glsl"
#ifdef LAYER_3
#include "deeper_layers.glsl"
#endif
#endif

void main() {
  SurfacePoint point = surface_point();
  Footprint footprint = Footprint(dFdx(point.uv), dFdy(point.uv));
  vec4 outer_base = fetch_of(outer_albedo, point.uv, footprint);
  vec3 normal_tangent = decode_normal(fetch_of(outer_normal, point.uv, footprint).xyz);

#ifdef LIGHT_FROM_MAP
  vec4 outer_light = covered(fetch_of(light_map, point.uv, footprint));
#ifdef LIGHT_COVERED
  outer_light.a = outer_base.a;
#endif
#elif defined(LIGHT_FROM_MEAN)
  vec3 outer_mean = fetch_of(outer_normal_mean, point.uv, footprint).rgb * 2.0 - 1.0;
  vec4 outer_light = vec4(mean_diffuse_light(point.world_from_tangent * outer_mean, point.position), outer_base.a);
#else
  vec4 outer_light = vec4(diffuse_light(point.world_from_tangent * normal_tangent, point.position), outer_base.a);
#endif
  vec3 color = outer_base.rgb * outer_light.rgb;

#ifdef INNER_LAYER
  vec3 view_tangent = normalize(eye_world.xyz - point.position) * point.world_from_tangent;
  vec2 texel = 1.0 / vec2(textureSize(inner_albedo, 0));
#ifdef LAYER_SHADOWS
  vec2 slant = slant_of_light(point) * texel;
#else
  vec2 slant = vec2(0.0);
#endif
  LightRay ray = LightRay(point.uv, slant, scattering * texel);

#ifdef LAYER_DEPTH
  InnerPoint inner = inner_point(point.uv, view_tangent, normal_tangent, thickness, texel);
#ifdef BASE_BLURRED
  vec4 inner_base = blurred_base(inner.uv, thickness * texel, inner.distance_texels / thickness, footprint);
#else
  vec4 inner_base = BASE_FILTER(inner_albedo, inner.uv, inner.distance_texels * texel, footprint);
#endif
#else
  // No depth: no offset, and a disc of radius 0 is its centre.
  vec4 inner_base = fetch_of(inner_albedo, point.uv, footprint);
#endif

#if defined(LAYER_DEPTH) || defined(LIGHT_FROM_VERTEX)
#ifdef LAYER_DEPTH
  ray.uv = inner.uv;
#endif
  vec3 inner_light = layer_light(2, point, ray, footprint);
#elif defined(LAYER_SHADOWS) && !defined(SHADOWS_LEFT_OUT)
#ifdef SHADOWS_PREMULTIPLIED
  vec3 inner_light = fetch_of(light_through, point.uv, footprint).rgb;
#else
  vec3 inner_light = outer_light.rgb * let_through(outer_light.a);
#endif
#else
  vec3 inner_light = outer_light.rgb;
#endif
#ifdef INNER_NORMAL
#ifdef LAYER_DEPTH
  inner_light = bumped_light(inner_light, inner_normal, inner.uv, inner.distance_texels * texel, point, footprint);
#else
  inner_light = bumped_light(inner_light, inner_normal, point.uv, vec2(0.0), point, footprint);
#endif
#endif
  vec3 inner_color = inner_base.rgb * inner_light;
#ifdef LAYER_3
  vec3 deeper = deeper_layers(point, EyeRay(view_tangent, normal_tangent, texel), ray, footprint);
  inner_color = mix(inner_color, deeper, inner_base.a);
#endif
  float n_dot_v = clamp(dot(normal_tangent, view_tangent), 0.0, 1.0);
  color = join_layers(color, inner_color, outer_base.a, n_dot_v);
#endif

  out_color = vec4(color, 1.0);
#ifdef LAMINA_EXTRA_FETCHES
  out_color += extra_fetches(outer_albedo);
#endif
}
