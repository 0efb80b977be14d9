// SPDX-License-Identifier: Apache-2.0
// Marks every texel that a chart of the unwrapped mesh covers with its own place: the seeds of jump_flood.frag.

layout(location = 0) out vec4 out_seed;

void main() { out_seed = vec4(gl_FragCoord.xy, 0.0, 0.0); }
