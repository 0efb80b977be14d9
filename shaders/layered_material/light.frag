// SPDX-License-Identifier: Apache-2.0
// Texture-space lighting: the outer layer's diffuse light, drawn through the unwrapped mesh (Oat 2006, section 4.5). The mapped
// normal is read at the texel's own place, at the base level. Output: rgb irradiance; alpha = the outer layer's transparency where layers shade
// what lies below them (a shadow without a fetch), else 1.
// LIGHT_COVERED: 1 everywhere that a chart covers.
#include "../common/frame.glsl"
#include "../common/surface.glsl"
#include "../common/mesh_in.glsl"

layout(binding = 5) uniform sampler2D outer_normal;
#if defined(LAYER_SHADOWS) && !defined(LIGHT_COVERED)
layout(binding = 4) uniform sampler2D outer_albedo;
#endif
layout(location = 0) out vec4 out_light;

void main() {
  SurfacePoint point = surface_point();
  vec3 normal_tangent = decode_normal(texture(outer_normal, point.uv).xyz);
  out_light = vec4(diffuse_light(point.world_from_tangent * normal_tangent, point.position), 1.0);
#if defined(LAYER_SHADOWS) && !defined(LIGHT_COVERED)
  out_light.a = texture(outer_albedo, point.uv).a;
#endif
}
