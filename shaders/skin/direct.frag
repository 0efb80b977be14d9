// SPDX-License-Identifier: Apache-2.0
// Skin in one pass: the model MODEL of reflected light for each lamp, without a map of light, and highlights.
#include "material.glsl"
#include "soft_shadow.glsl"
#include "surface_light.glsl"
#include "../common/extra_fetches.glsl"

layout(location = 4) in float in_curvature;  // 1/mm
layout(location = 0) out vec4 out_color;

#include "models/lambert.glsl"
#include "models/red_wrap.glsl"
#include "models/curvature_wrap.glsl"
#include "models/blended_normals.glsl"
#include "models/clement_layers.glsl"
#include "models/spherical_gaussians.glsl"
#include "models/preintegrated.glsl"

void main() {
  SkinPoint point = skin_point();
  vec2 map = specular_map(point.uv);
  vec3 to_eye = normalize(eye_world.xyz - point.position), color = point.albedo * ambient.rgb;
  float leaving = entering(dot(point.normal, to_eye), map);
  color *= leaving;
  for (int i = 0; i < light_count.x; ++i) {
    ArrivingLight light = arriving_light(i, point.position);
    float lit = soft_shadow(i, point.position, point.smooth_normal, light.direction);
    // Around the edge, light comes from where it entered less slantingly.
    float into = entering(max(dot(point.normal, light.direction), 0.15), map) * leaving;
    vec3 reflected = MODEL(point, light.direction, lit) * into;
    float shine = HIGHLIGHT_SHADOW(lit) * highlight(point, map, light.direction, to_eye);
    color += light.irradiance * (reflected + shine + back_scattered(point, light.direction));
  }
  out_color = vec4(color, 1.0);
#ifdef LAMINA_EXTRA_FETCHES
  out_color += extra_fetches(skin_albedo);
#endif
}
