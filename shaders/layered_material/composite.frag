// SPDX-License-Identifier: Apache-2.0
// The layered material on screen. One of these definitions says where the light comes from:
//   LIGHT_FROM_MAP     both layers from the light map, the inner one's blurred by the thickness (Oat 2006, listing 3)
//   LIGHT_FROM_TAPS    outer: N.L of the mapped normal; inner: the mean of N.L over 13 taps of the normal map (section 4.6, first
//                      optimization; the lighting terms are averaged, never the normals)
//   LIGHT_FROM_VERTEX  outer: N.L of the mapped normal; inner: N.L of the vertex normal (section 4.6, second optimization)
//   LIGHT_FROM_MEAN    both layers by the mean of the normals and by how much they scatter (mean_normal.glsl)
// and two which filter takes the place of the 13 taps, each a function of (sampler, center, radius, footprint):
//   BASE_BLURRED  the inner layer is read from maps that were blurred once (blurred_base.glsl)
//   LIGHT_FILTER, BASE_FILTER  poisson_disc, golden_disc, ring_disc, merged_disc, one_fetch_disc, one_fetch_thirteen
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
#ifndef LIGHT_FILTER
#define LIGHT_FILTER poisson_disc
#endif
#ifndef BASE_FILTER
#define BASE_FILTER poisson_disc
#endif

#ifdef LIGHT_FROM_MAP
layout(binding = 7) uniform sampler2D light_map;
#endif
#ifdef LIGHT_FROM_MEAN
#include "mean_normal.glsl"
layout(binding = 7) uniform sampler2D outer_normal_mean;  // 1/2 + 1/2 of the mean of unit normals
#endif
layout(location = 0) out vec4 out_color;

#ifdef LIGHT_FROM_TAPS
// The disc of poisson_disc() over the normal map, each tap turned into light before the mean is taken.
vec3 light_over_disc(SurfacePoint point, vec2 center, vec2 radius, Footprint footprint) {
  vec3 texel = textureGrad(outer_normal, center, footprint.uv_dx, footprint.uv_dy).xyz;
  vec3 middle = diffuse_light(point.world_from_tangent * decode_normal(texel), point.position);
  vec3 difference = vec3(0.0);
  for (int i = 0; i < 12; ++i) {
    texel = textureGrad(outer_normal, center + disc_taps[i] * radius, footprint.uv_dx, footprint.uv_dy).xyz;
    difference += diffuse_light(point.world_from_tangent * decode_normal(texel), point.position) - middle;
  }
  return middle + difference / 13.0;
}
#endif

void main() {
  SurfacePoint point = surface_point();
  Footprint footprint = Footprint(dFdx(point.uv), dFdy(point.uv));
  vec4 outer_base = textureGrad(outer_albedo, point.uv, footprint.uv_dx, footprint.uv_dy);
  vec3 normal_tangent = decode_normal(textureGrad(outer_normal, point.uv, footprint.uv_dx, footprint.uv_dy).xyz);

#ifdef LIGHT_FROM_MAP
  vec3 outer_light = textureGrad(light_map, point.uv, footprint.uv_dx, footprint.uv_dy).rgb;
#elif defined(LIGHT_FROM_MEAN)
  vec3 outer_mean = fetch_of(outer_normal_mean, point.uv, footprint).rgb * 2.0 - 1.0;
  vec3 outer_light = mean_diffuse_light(point.world_from_tangent * outer_mean, point.position);
#else
  vec3 outer_light = diffuse_light(point.world_from_tangent * normal_tangent, point.position);
#endif
  vec3 color = outer_base.rgb * outer_light;

#ifdef INNER_LAYER
  vec3 view_tangent = normalize(eye_world.xyz - point.position) * point.world_from_tangent;
#ifdef LAYER_DEPTH
  vec2 texel = 1.0 / vec2(textureSize(inner_albedo, 0));
  vec2 light_radius = thickness * scattering * texel;
  InnerPoint inner = inner_point(point.uv, view_tangent, normal_tangent, thickness, texel);
#ifdef BASE_BLURRED
  vec3 inner_base = blurred_base(inner.uv, thickness * texel, inner.distance_texels / thickness, footprint).rgb;
#else
  vec3 inner_base = BASE_FILTER(inner_albedo, inner.uv, inner.distance_texels * texel, footprint).rgb;
#endif
#else
  // No depth: no offset, and a disc of radius 0 is its centre.
  vec3 inner_base = textureGrad(inner_albedo, point.uv, footprint.uv_dx, footprint.uv_dy).rgb;
#endif

#if defined(LIGHT_FROM_VERTEX)
  vec3 inner_light = diffuse_light(point.normal, point.position);
#elif !defined(LAYER_DEPTH)
  vec3 inner_light = outer_light;
#elif defined(LIGHT_FROM_MAP)
  vec3 inner_light = LIGHT_FILTER(light_map, inner.uv, light_radius, footprint).rgb;
#elif defined(LIGHT_FROM_MEAN)
  vec3 inner_mean = LIGHT_FILTER(outer_normal_mean, inner.uv, light_radius, footprint).rgb * 2.0 - 1.0;
  vec3 inner_light = mean_diffuse_light(point.world_from_tangent * inner_mean, point.position);
#else
  vec3 inner_light = light_over_disc(point, inner.uv, light_radius, footprint);
#endif
  float n_dot_v = clamp(dot(normal_tangent, view_tangent), 0.0, 1.0);
  color = join_layers(color, inner_base * inner_light, outer_base.a, n_dot_v);
#endif

  out_color = vec4(color, 1.0);
#ifdef LAMINA_EXTRA_FETCHES
  out_color += extra_fetches(outer_albedo);
#endif
}
