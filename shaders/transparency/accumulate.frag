// SPDX-License-Identifier: Apache-2.0
// A fragment's share of the weighted sums, for additive blending, and its opacity, for the product of what the layers let
// through. The factor of 2^-5 changes no quotient. With it and the bound, sums of 32 fragments fit into 16-bit floats, whatever
// their weights and colours; AS_PRINTED leaves both out.
#include "../common/frame.glsl"
#include "../common/surface.glsl"
#include "../common/mesh_in.glsl"
#include "surface.glsl"
#include "weights.glsl"

layout(location = 0) out vec4 out_sums;      // color alpha w; alpha w
layout(location = 1) out vec4 out_covering;  // opacity, for blending over

const float greatest_half = 65504.0;

void main() {
  vec4 layer = shaded_surface();
  float weight = WEIGHT(layer.a, 1.0 / gl_FragCoord.w, gl_FragCoord.z);
  vec4 weighted = vec4(layer.rgb, 1.0) * (layer.a * weight);
#ifndef AS_PRINTED
  weighted = min(weighted / 32.0, vec4(greatest_half / 32.0));
#endif
  out_sums = weighted;
  out_covering = vec4(layer.a);
}
