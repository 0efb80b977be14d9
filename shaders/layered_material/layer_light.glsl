// SPDX-License-Identifier: Apache-2.0
// The light of layers below the surface: blurred by their depth, and where layers shade each other, by what the layers above let
// through (Oat 2006, section 4.7; "Efficient Shader Tricks That Will Impress Your Friends", GDC 2006). One of the definitions of
// composite.frag says where the light comes from. LAYER_SHADOWS are taken
//   SHADOWS_AT_TAPS    light times transparency at every tap of the 13, averaged, and never divided by the transparencies' sum: that
//                      would undo the shadow. A tap is a ray of light through the layers: it meets layer j at (D - D_j) of its offset
//   SHADOWS_OF_MEANS   the filtered light times the filtered transparencies
//   SHADOWS_AT_CENTER  the light times the transparencies on the ray of light alone
//   SHADOWS_PREMULTIPLIED  of means, but light times the outer layer's transparency is filtered as one, from a map of its own
//   SHADOWS_LEFT_OUT   not at all
// The map's alpha is the outer layer's transparency: its shadow costs no fetch.

// Where light that arrives at a layer's point went through the layers above.
struct LightRay {
  vec2 uv;      // of the point, in the layer
  vec2 slant;   // texture coordinates that light comes from, a texel of depth
  vec2 spread;  // radius of its blur, a texel of depth
};

float let_through(float transparency) { return mix(1.0, transparency, shadowing); }

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

// The light at a layer without shadows, at the surface above `uv`. `radius`: of its blur, texture coordinates. With a map alpha is
// the outer layer's transparency, filtered as the light is.
vec4 blurred_light(SurfacePoint point, vec2 uv, vec2 radius, Footprint footprint) {
#if defined(LIGHT_FROM_VERTEX)
  return vec4(diffuse_light(point.normal, point.position), 1.0);
#elif defined(LIGHT_FROM_MAP)
  return covered(LIGHT_FILTER(light_map, uv, radius, footprint));
#elif defined(LIGHT_FROM_MEAN)
  vec3 mean = LIGHT_FILTER(outer_normal_mean, uv, radius, footprint).rgb * 2.0 - 1.0;
  return vec4(mean_diffuse_light(point.world_from_tangent * mean, point.position), 1.0);
#else
  return vec4(light_over_disc(point, uv, radius, footprint), 1.0);
#endif
}

#ifdef LAYER_SHADOWS
#ifdef SHADOWS_PREMULTIPLIED
layout(binding = 8) uniform sampler2D light_through;  // irradiance that the outer layer lets through
#endif
// Where light comes from on the whole: the mean of the lights' directions by what they give to the smooth surface, in tangent space.
// A map keeps no directions, so that all its lights slant as one; at more than 76 degrees from the normal as at 76.
vec2 slant_of_light(SurfacePoint point) {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < light_count.x; ++i) {
    vec3 to_light = light_position[i].xyz - point.position * light_position[i].w;
    float squared = max(dot(to_light, to_light), 1e-8);
    vec3 direction = to_light * inversesqrt(squared);
    float given = max(dot(point.normal, direction), 0.0) * dot(light_radiance[i].rgb, vec3(1.0 / 3.0));
    sum += direction * (light_position[i].w > 0.0 ? given / squared : given);
  }
  vec3 tangent = sum * point.world_from_tangent;
  return tangent.xy / max(tangent.z, max(0.25 * length(tangent), 1e-8));
}

// What the layers above `layer`, but the outer one, let through along a ray of light whose offset is `tap` radii; footprints as wide
// as `width` radii.
#define ABOVE(J, SOURCE)                                                                                          \
  if (layer > J) {                                                                                                \
    float up = depth_of(layer) - depth_of(J);                                                                     \
    through *= let_through(SHADOW_FETCH(SOURCE, ray.uv + up * (ray.slant + tap * ray.spread), up * ray.spread).a); \
  }
#if defined(SHADOWS_OF_MEANS) || defined(SHADOWS_PREMULTIPLIED)
#define SHADOW_FETCH(SOURCE, UV, RADIUS) LIGHT_FILTER(SOURCE, UV, RADIUS, footprint)
#else
#define SHADOW_FETCH(SOURCE, UV, RADIUS) fetch_of(SOURCE, UV, footprint)
#endif
float through_deeper(int layer, LightRay ray, vec2 tap, Footprint footprint) {
  float through = 1.0;
#ifdef LAYER_3
  ABOVE(2, inner_albedo)
#endif
#ifdef LAYER_4
  ABOVE(3, layer_3_albedo)
#endif
#ifdef LAYER_5
  ABOVE(4, layer_4_albedo)
#endif
#ifdef LAYER_6
  ABOVE(5, layer_5_albedo)
#endif
  return through;
}
#endif

#if defined(LAYER_SHADOWS) && defined(SHADOWS_AT_TAPS)
vec3 shadowed_tap(int layer, LightRay ray, vec2 tap, Footprint footprint) {
  vec4 light = fetch_of(light_map, ray.uv + depth_of(layer) * (ray.slant + tap * ray.spread), footprint);
  return light.rgb * (let_through(light.a) * through_deeper(layer, ray, tap, footprint));
}
#endif

// Light at a layer, 2 to 6, at ray.uv.
vec3 layer_light(int layer, SurfacePoint point, LightRay ray, Footprint footprint) {
  float depth = depth_of(layer);
#if !defined(LAYER_SHADOWS) || defined(SHADOWS_LEFT_OUT)
  return blurred_light(point, ray.uv, depth * ray.spread, footprint).rgb;
#elif defined(SHADOWS_AT_TAPS)
  vec3 middle = shadowed_tap(layer, ray, vec2(0.0), footprint), difference = vec3(0.0);
  for (int i = 0; i < 12; ++i) difference += shadowed_tap(layer, ray, disc_taps[i], footprint) - middle;
  return difference / 13.0 + middle;
#else
  vec2 entry = ray.uv + depth * ray.slant;
#ifdef SHADOWS_PREMULTIPLIED
  vec4 light = vec4(LIGHT_FILTER(light_through, entry, depth * ray.spread, footprint).rgb, 1.0);
#else
  vec4 light = blurred_light(point, entry, depth * ray.spread, footprint);
#endif
#if defined(SHADOWS_AT_CENTER) && defined(LIGHT_FROM_MAP) && !defined(LIGHT_COVERED)
  light.a = fetch_of(light_map, entry, footprint).a;
#elif !defined(LIGHT_FROM_MAP) || defined(LIGHT_COVERED)
  light.a = fetch_of(outer_albedo, entry, footprint).a;
#endif
  return light.rgb * (let_through(light.a) * through_deeper(layer, ray, vec2(0.0), footprint));
#endif
}
