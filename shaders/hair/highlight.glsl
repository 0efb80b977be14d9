// SPDX-License-Identifier: Apache-2.0
// The highlight along strands, from the two lights that count most and from the camera. `at`: the card; `along`: the strand.
#include "strand_specular/strand_specular.glsl"

vec3 strand_highlight(SurfacePoint at, vec3 along, vec3 to_eye, ivec2 lights) {
  vec3 sum = vec3(0.0);
#ifdef HIGHLIGHT
  // Scales tilt towards the tip: the frame turns about the third axis.
  vec3 strand = normalize(along + shift * at.normal), normal = normalize(at.normal - shift * along);
  vec3 across = cross(normal, strand);
  vec3 eye = vec3(dot(to_eye, strand), dot(to_eye, across), dot(to_eye, normal));
  for (int k = 0; k < 2; ++k) {
    if (lights[k] < 0) continue;
    Arriving from = arriving(lights[k], at.position);
    vec3 light = vec3(dot(from.direction, strand), dot(from.direction, across), dot(from.direction, normal));
    sum += from.light * strand_reflected(light, eye, roughness_along, roughness_across);
  }
#ifdef CAMERA_LIGHT
  sum += camera_light * strand_reflected(eye, eye, roughness_along, roughness_across);
#endif
  sum *= strength;
#endif
  return sum;
}
