// SPDX-License-Identifier: Apache-2.0
// All light of a card at once, for cards that are blended: premultiplied by the opacity. OPAQUE_FROM: draws only what is at least
// that opaque, and draws it opaque. PEELED: the furthest layer before
// that of the repetition before, over the picture so far.
#include "cards_in.glsl"
#include "lighting.glsl"
#include "strand.glsl"
#include "highlight.glsl"

layout(binding = 4) uniform sampler2D hair_albedo;
#ifdef PEELED
layout(binding = 6) uniform sampler2D layer_depth;  // of the layer behind
layout(binding = 7) uniform sampler2D depth;        // of what is opaque
layout(binding = 8) uniform sampler2D frame;
#endif
layout(location = 0) out vec4 out_color;

void main() {
  vec4 texel = texture(hair_albedo, in_uv);
  if (texel.a < 1.0 / 255.0) discard;
#ifdef OPAQUE_FROM
  if (texel.a < OPAQUE_FROM) discard;
  texel.a = 1.0;
#endif
#ifdef PEELED
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  if (gl_FragCoord.z > texelFetch(depth, pixel, 0).r) discard;
  if (iteration.x > 0 && gl_FragCoord.z >= texelFetch(layer_depth, pixel, 0).r) discard;
#endif
  SurfacePoint at = surface_point();
  vec3 to_eye = normalize(eye_world.xyz - at.position);
  vec3 light = blinn_phong(at.position, at.normal, to_eye, texel.rgb, gloss, gloss_strength) +
               strand_highlight(at, DIRECTION(at), to_eye, in_lights);
  out_color = vec4(light * texel.a, texel.a);
#ifdef PEELED
  // Not blended: of several fragments the furthest, which comes last or is hidden, must be laid over what was there before all.
  out_color += (1.0 - texel.a) * texelFetch(frame, pixel, 0);
#endif
}
