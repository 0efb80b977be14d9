// SPDX-License-Identifier: Apache-2.0
// Draws nothing. The first pass that writes the frame clears it, and a scene of fog alone has no other before the truth reads it.
layout(location = 0) out vec4 out_color;

void main() { discard; }
