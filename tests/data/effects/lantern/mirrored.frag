// SPDX-License-Identifier: Apache-2.0
// What the mirror shows: the albedo of every surface, whoever draws it.
layout(location = 3) in vec2 in_uv;
layout(binding = 4) uniform sampler2D albedo;
layout(location = 0) out vec4 out_color;

void main() { out_color = vec4(texture(albedo, in_uv).rgb, 1.0); }
