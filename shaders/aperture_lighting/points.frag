// SPDX-License-Identifier: Apache-2.0
// What each pixel shows, for the offline truth: where it lies, which way it faces, its colour and its apertures.
#include "../common/frame.glsl"
#include "../common/surface.glsl"
#include "../common/mesh_in.glsl"
#include "apertures.glsl"

layout(binding = 4) uniform sampler2D albedo;
layout(location = 0) out vec4 out_point;   // world; w = 1 where there is one
layout(location = 1) out vec4 out_normal;  // world, unit
layout(location = 2) out vec4 out_albedo;  // linear
layout(location = 3) out vec4 out_apertures[APERTURES];

void main() {
  vec3 normal = unit_or(in_normal, vec3(0, 1, 0));
  vec4 apertures[APERTURES];
  read_apertures(in_uv, normal, apertures);
  out_point = vec4(in_position, 1.0);
  out_normal = vec4(normal, 0.0);
  out_albedo = vec4(texture(albedo, in_uv).rgb, 1.0);
  for (int i = 0; i < APERTURES; ++i) out_apertures[i] = apertures[i];
#ifdef APERTURE_CHOICE
  // With the length that says which of the two counts.
  out_apertures[1].xyz *= mix(0.0625, 1.0, blocked_weight(kept_aperture(1, in_uv)));
#endif
}
