// SPDX-License-Identifier: Apache-2.0
// The inner layer's albedo times the light on the surface: what is left of the material where nothing may cost more than a fetch.
#include "common/frame.glsl"
#include "common/surface.glsl"
#include "common/mesh_in.glsl"

layout(binding = 4) uniform sampler2D inner_albedo;
layout(location = 0) out vec4 color;

void main() { color = vec4(texture(inner_albedo, in_uv).rgb * diffuse_light(normalize(in_normal), in_position), 1.0); }
