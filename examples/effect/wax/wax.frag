// SPDX-License-Identifier: Apache-2.0
// The albedo times max(0, (N.L + wrap) / (1 + wrap)), over all lights, and the ambient light; linear.
#include "common/frame.glsl"
#include "common/surface.glsl"
#include "common/mesh_in.glsl"

layout(std140, binding = 3) uniform Effect { float wrap; };
layout(binding = 4) uniform sampler2D wax_albedo;
layout(location = 0) out vec4 color;

void main() {
  vec3 normal = normalize(in_normal), sum = ambient.rgb;
#ifdef NO_WRAP
  float around = 0.0;
#else
  float around = wrap;
#endif
  for (int i = 0; i < light_count.x; ++i) {
    vec3 to_light = light_position[i].xyz - light_position[i].w * in_position;
    float falloff = light_position[i].w > 0.0 ? 1.0 / dot(to_light, to_light) : 1.0;
    float cosine = dot(normal, normalize(to_light));
    sum += light_radiance[i].rgb * falloff * max(0.0, (cosine + around) / (1.0 + around));
  }
  color = vec4(texture(wax_albedo, in_uv).rgb * sum, 1.0);
}
