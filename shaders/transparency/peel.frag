// SPDX-License-Identifier: Apache-2.0
// One layer of depth peeling, front to back: Everitt, "Interactive Order-Independent Transparency", NVIDIA 2001. The depth test
// leaves the nearest fragment behind the layer before; it goes under the layers that are there.
#include "../common/frame.glsl"
#include "../common/surface.glsl"
#include "../common/mesh_in.glsl"
#include "surface.glsl"

layout(binding = 5) uniform sampler2D depth;         // of what is opaque
layout(binding = 6) uniform sampler2D depth_before;  // of the layer before; 0 before the first
layout(binding = 7) uniform sampler2D layers_before;
layout(location = 0) out vec4 out_layers;  // premultiplied; alpha: opacity of all layers so far

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 layers = texelFetch(layers_before, pixel, 0);
  if (gl_FragCoord.z <= texelFetch(depth_before, pixel, 0).r || gl_FragCoord.z > texelFetch(depth, pixel, 0).r ||
      layers.a >= 1.0)
    discard;
  vec4 layer = shaded_surface();
  out_layers = layers + (1.0 - layers.a) * vec4(layer.rgb * layer.a, layer.a);
}
