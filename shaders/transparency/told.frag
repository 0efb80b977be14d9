// SPDX-License-Identifier: Apache-2.0
// For the truth: the frame behind the transparent surfaces, and how many layers this variant keeps, 0 for all.
layout(binding = 4) uniform sampler2D frame;
layout(location = 0) out vec4 out_behind;

void main() { out_behind = vec4(texelFetch(frame, ivec2(gl_FragCoord.xy), 0).rgb, float(KEPT_LAYERS)); }
