// SPDX-License-Identifier: Apache-2.0
// Screen-space diffusion's light buffer: light that enters the skin, times the albedo's root, where skin is seen; alpha 1
// there. And the view depth in metres.
#include "material.glsl"
#include "soft_shadow.glsl"
#include "surface_light.glsl"

layout(location = 0) out vec4 out_light;
layout(location = 1) out vec4 out_depth;

void main() {
  SkinPoint point = skin_point();
  vec2 map = specular_map(point.uv);
  vec3 sum = ambient.rgb;
  for (int i = 0; i < light_count.x; ++i) {
    ArrivingLight light = arriving_light(i, point.position);
    float c = max(dot(point.normal, light.direction), 0.0);
    sum += light.irradiance * (soft_shadow(i, point.position, point.smooth_normal, light.direction) * c * entering(c, map));
  }
  out_light = vec4(sum * sqrt(point.albedo), 1.0);
  out_depth = vec4(1.0 / gl_FragCoord.w, 0.0, 0.0, 1.0);
}
