// SPDX-License-Identifier: Apache-2.0
// How much light a piece of the grid brings to where it lands: the area through which it came in over that on which it lands. Sheets
// that fold over each other are added.
layout(location = 0) in vec2 in_ground;
layout(location = 1) in vec2 in_lands;
layout(location = 2) in float in_passes;
layout(location = 0) out vec4 out_light;

float area(vec2 right, vec2 down) { return abs(right.x * down.y - right.y * down.x); }

void main() {
  float came = area(dFdx(in_ground), dFdy(in_ground)), lands = area(dFdx(in_lands), dFdy(in_lands));
  out_light = vec4(in_passes * min(came / max(lands, 1e-12), 200.0), 0.0, 0.0, 1.0);
}
