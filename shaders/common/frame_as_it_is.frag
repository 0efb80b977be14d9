// SPDX-License-Identifier: Apache-2.0
// For a truth: the picture as it is so far.
layout(binding = 4) uniform sampler2D frame;
layout(location = 0) out vec4 out_behind;

void main() { out_behind = vec4(texelFetch(frame, ivec2(gl_FragCoord.xy), 0).rgb, 1.0); }
