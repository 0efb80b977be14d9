// SPDX-License-Identifier: Apache-2.0
// Texture-space irradiance (Green, GDC 2004; d'Eon and Luebke, GPU Gems 3, chapter 14): light that enters the skin, texel by
// texel of the unwrap, times the albedo's root. Also how many millimetres a texel is along u and v, by which blurs correct
// stretch.
#include "material.glsl"
#include "soft_shadow.glsl"
#include "surface_light.glsl"

layout(location = 0) out vec4 out_light;
layout(location = 1) out vec4 out_stretch;

void main() {
  SkinPoint point = skin_point();
  vec2 map = specular_map(point.uv);
  vec3 sum = ambient.rgb;
  for (int i = 0; i < light_count.x; ++i) {
    ArrivingLight light = arriving_light(i, point.position);
    float c = max(dot(point.normal, light.direction), 0.0);
    float lit = c > 0.0 ? soft_shadow(i, point.position, point.smooth_normal, light.direction) : 0.0;
    sum += light.irradiance * (lit * c * entering(c, map));
  }
  out_light = vec4(sum * sqrt(point.albedo), 1.0);
  out_stretch = vec4(1000.0 * length(dFdx(point.position)), 1000.0 * length(dFdy(point.position)), 0.0, 1.0);
}
