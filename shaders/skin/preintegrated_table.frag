// SPDX-License-Identifier: Apache-2.0
// The light of a ball of skin under a unit light, over N.L (x: -1 to 1) and curvature (y: 0 to 1 / (4 mm)). INTEGRATED is
//   sphere_light  the profile over the sphere by chords: all that a ball does
//   ring_light    along a great circle, by the Gaussians' one-dimensional form (Penner, SIGGRAPH 2011 course); the two-dimensional
//                 1 / (2 pi v), often used there, weighs the Gaussians wrongly
#include "profile_numbers.glsl"
layout(location = 0) out vec4 out_light;

// Mean of max(0, N.L) over a circle at an angle around a point.
float mean_on_circle(float c, float angle) {
  float along = c * cos(angle), beside = sqrt(max(1.0 - c * c, 0.0)) * sin(angle);
  if (abs(along) >= beside) return max(along, 0.0);
  float t = -along / beside;
  return (along * acos(t) + beside * sqrt(max(1.0 - t * t, 0.0))) / 3.14159265;
}

vec3 sphere_light(float c, float radius) {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 6; ++i) {
    float sharpness = radius * radius / profile_variance(i), mass = 1.0 - exp(-2.0 * sharpness), lit = 0.0;
    const int steps = 96;
    for (int k = 0; k < steps; ++k) {
      float lowered = -log(max(1.0 - (float(k) + 0.5) / float(steps) * mass, 1e-7)) / sharpness;
      lit += mean_on_circle(c, 2.0 * asin(sqrt(min(0.5 * lowered, 1.0))));
    }
    sum += profile_weight(i) * (mass * lit / float(steps));
  }
  return sum;
}

vec3 ring_light(float c, float radius) {
  vec3 sum = vec3(0.0), weights = vec3(0.0);
  float here = acos(clamp(c, -1.0, 1.0));
  const int steps = 400;
  for (int k = 0; k < steps; ++k) {
    // Closer steps in the middle.
    float t = (float(k) + 0.5) / float(steps) * 2.0 - 1.0, x = 3.14159265 * t * t * t, chord = 2.0 * radius * sin(0.5 * x);
    vec3 line = vec3(0.0);
    for (int i = 0; i < 6; ++i)
      line += profile_weight(i) * exp(-0.5 * chord * chord / profile_variance(i)) * inversesqrt(6.2831853 * profile_variance(i));
    line *= t * t;
    sum += line * max(cos(here + x), 0.0), weights += line;
  }
  return sum / weights;
}

void main() {
  vec2 place = (gl_FragCoord.xy - 0.5) / vec2(63.0, 31.0);
  out_light = vec4(INTEGRATED(place.x * 2.0 - 1.0, 1.0 / max(place.y * 0.25, 0.002)), 1.0);
}
