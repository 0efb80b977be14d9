// SPDX-License-Identifier: Apache-2.0
// Draws nothing. The first pass that writes the frame clears it, and a scene may have no other before something reads it.
layout(location = 0) out vec4 out_color;

void main() { discard; }
