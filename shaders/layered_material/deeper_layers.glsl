// SPDX-License-Identifier: Apache-2.0
// Layers 3 to 6: seen as the inner one is, each along the ray of the outer normal at its own depth, and joined from the bottom up by
// transparencies alone. N.V counts once, at the outer layer: N times it would hide the base by (N.V)^N.

// A layer's colour and transparency at the eye's ray, and its light, which BUMPED_N turns into that of the layer's own normals.
#define DEEPER(N, SOURCE)                                                                                          \
  vec4 seen_##N(SurfacePoint point, EyeRay eye, LightRay ray, Footprint footprint) {                                \
    InnerPoint at = inner_point(point.uv, eye.view_tangent, eye.normal_tangent, depth_of(N), eye.texel);            \
    vec4 base = BASE_FILTER(SOURCE, at.uv, at.distance_texels * eye.texel, footprint);                              \
    vec3 light = layer_light(N, point, LightRay(at.uv, ray.slant, ray.spread), footprint);                          \
    BUMPED_##N                                                                                                     \
    return vec4(base.rgb * light, base.a);                                                                         \
  }
#define BUMPED(NORMALS) light = bumped_light(light, NORMALS, at.uv, at.distance_texels * eye.texel, point, footprint);
#ifdef LAYER_3_NORMAL
#define BUMPED_3 BUMPED(layer_3_normal)
#else
#define BUMPED_3
#endif
#ifdef LAYER_4_NORMAL
#define BUMPED_4 BUMPED(layer_4_normal)
#else
#define BUMPED_4
#endif
#ifdef LAYER_5_NORMAL
#define BUMPED_5 BUMPED(layer_5_normal)
#else
#define BUMPED_5
#endif
#ifdef LAYER_6_NORMAL
#define BUMPED_6 BUMPED(layer_6_normal)
#else
#define BUMPED_6
#endif

struct EyeRay {
  vec3 view_tangent, normal_tangent;
  vec2 texel;
};

DEEPER(3, layer_3_albedo)
#ifdef LAYER_4
DEEPER(4, layer_4_albedo)
#endif
#ifdef LAYER_5
DEEPER(5, layer_5_albedo)
#endif
#ifdef LAYER_6
DEEPER(6, layer_6_albedo)
#endif

// What is seen below the inner layer. The last layer hides what lies below it.
vec3 deeper_layers(SurfacePoint point, EyeRay eye, LightRay ray, Footprint footprint) {
  vec4 third = seen_3(point, eye, ray, footprint);
  vec3 color = third.rgb;
#ifdef LAYER_4
  vec4 fourth = seen_4(point, eye, ray, footprint);
  vec3 below = fourth.rgb;
#ifdef LAYER_5
  vec4 fifth = seen_5(point, eye, ray, footprint);
  vec3 below_fourth = fifth.rgb;
#ifdef LAYER_6
  below_fourth = mix(fifth.rgb, seen_6(point, eye, ray, footprint).rgb, fifth.a);
#endif
  below = mix(fourth.rgb, below_fourth, fourth.a);
#endif
  color = mix(third.rgb, below, third.a);
#endif
  return color;
}
