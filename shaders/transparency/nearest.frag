// SPDX-License-Identifier: Apache-2.0
// The nearest transparent surface, shaded forward; the depth test chooses it.
#include "../common/frame.glsl"
#include "../common/surface.glsl"
#include "../common/mesh_in.glsl"
#include "surface.glsl"

layout(binding = 5) uniform sampler2D depth;  // of what is opaque
layout(location = 0) out vec4 out_layer;      // premultiplied

void main() {
  if (gl_FragCoord.z > texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r) discard;
  vec4 layer = shaded_surface();
  if (layer.a == 0.0) discard;
  out_layer = vec4(layer.rgb * layer.a, layer.a);
}
