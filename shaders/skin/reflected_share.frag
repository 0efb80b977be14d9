// SPDX-License-Identifier: Apache-2.0
// The share of light from a direction that Kelemen and Szirmay-Kalos' reflection sends back, over N.V (x) and the slope m (y):
// the first and last texels hold 0 and 1. Importance sampling of Beckmann's slopes by even steps.
#include "facets.glsl"
layout(location = 0) out float out_share;

void main() {
  vec2 place = (gl_FragCoord.xy - 0.5) / 31.0;
  float nv = max(place.x, 0.01), m = max(place.y, 0.02), sum = 0.0;
  vec3 to_eye = vec3(sqrt(1.0 - nv * nv), 0.0, nv);
  const int rings = 48, turns = 24;
  for (int i = 0; i < rings; ++i) {
    float tangent = -m * m * log(1.0 - (float(i) + 0.5) / float(rings)), nh = inversesqrt(1.0 + tangent);
    float sh = sqrt(max(1.0 - nh * nh, 0.0));
    for (int k = 0; k < turns; ++k) {
      float turn = 6.2831853 * (float(k) + 0.5) / float(turns);
      vec3 h = vec3(sh * cos(turn), sh * sin(turn), nh);
      float hv = dot(h, to_eye);
      vec3 to_light = 2.0 * hv * h - to_eye;
      // PH F / (4 hv^2) N.L, over pi, through the pdf PH nh / (4 pi hv) of the light's direction.
      sum += hv > 0.0 && to_light.z > 0.0 ? schlick(hv, 0.028) * to_light.z / (hv * nh) : 0.0;
    }
  }
  out_share = min(sum / float(rings * turns), 1.0);
}
