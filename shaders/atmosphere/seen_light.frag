// SPDX-License-Identifier: Apache-2.0
// For the truth: what each pixel shows without air.
layout(binding = 4) uniform sampler2D frame;
layout(location = 0) out vec4 out_light;

void main() { out_light = vec4(texelFetch(frame, ivec2(gl_FragCoord.xy), 0).rgb, 1.0); }
