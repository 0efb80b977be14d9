// SPDX-License-Identifier: Apache-2.0
// What the mirror shows: every opaque surface as plain diffuse light lights it, and how far it is from the eye's reflection.
#include "../common/frame.glsl"
#include "../common/surface.glsl"
#include "../common/mesh_in.glsl"
#include "../common/anisotropic.glsl"

layout(binding = 4) uniform sampler2D albedo;
layout(location = 0) out vec4 out_color;
layout(location = 1) out float out_view_depth;

void main() {
  out_color = vec4(anisotropic_texture(albedo, in_uv).rgb * diffuse_light(normalize(in_normal), in_position), 1.0);
  out_view_depth = 1.0 / gl_FragCoord.w;
}
