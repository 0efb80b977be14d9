// SPDX-License-Identifier: Apache-2.0
// Skin on screen: diffused light from the light map, times the rest of the albedo, and highlights, which are not diffused. The map
// has one level: the light of a point is asked for, and diffusion has smoothed it already. Mips wiped the features off a small face.
#include "material.glsl"
#include "soft_shadow.glsl"
#include "surface_light.glsl"
#include "../common/extra_fetches.glsl"

layout(binding = 9) uniform sampler2D diffused;
layout(location = 0) out vec4 out_color;

void main() {
  SkinPoint point = skin_point();
  vec2 map = specular_map(point.uv);
  vec3 to_eye = normalize(eye_world.xyz - point.position);
  vec3 color = textureLod(diffused, point.uv, 0.0).rgb * sqrt(point.albedo) * entering(dot(point.normal, to_eye), map);
#if defined(SPECULAR) || defined(OIL) || defined(RIM) || defined(BACK_SCATTERING)
  for (int i = 0; i < light_count.x; ++i) {
    ArrivingLight light = arriving_light(i, point.position);
    float lit = soft_shadow(i, point.position, point.smooth_normal, light.direction);
    color += light.irradiance * (lit * highlight(point, map, light.direction, to_eye));
    color += light.irradiance * back_scattered(point, light.direction);
  }
#endif
  out_color = vec4(color, 1.0);
#ifdef LAMINA_EXTRA_FETCHES
  out_color += extra_fetches(skin_albedo);
#endif
}
