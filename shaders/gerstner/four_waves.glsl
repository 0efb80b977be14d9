// SPDX-License-Identifier: Apache-2.0
// Four waves of 8, 5, 3.2 and 2 m whose steepnesses sum to 0.8: a point of the surface by component. 0 to 2: x, height, z of its
// place; 3 to 5: of its normal.
#include "gerstner.glsl"

WavePoint four_waves(float x, float z, float time, float steepness) {
  const float lengths[4] = float[](8.0, 5.0, 3.2, 2.0), amplitudes[4] = float[](0.18, 0.10, 0.06, 0.03),
              degrees_from[4] = float[](10.0, 55.0, -40.0, 100.0);
  WavePoint point = WavePoint(vec3(0), vec3(0), vec3(0));
  for (int i = 0; i < 4; ++i) {
    float turn = radians(degrees_from[i]);
    add_wave(point, Wave(amplitudes[i], lengths[i], vec2(cos(turn), sin(turn)), steepness), vec2(x, z), time, 0.0, 1.0);
  }
  return point;
}
float component_of(float x, float z, WavePoint point, vec3 normal, float component) {
  int i = int(component);
  return i < 3 ? (vec3(x, 0.0, z) + point.offset)[i] : normal[i - 3];
}

float exact_gerstner(float x, float z, float time, float component) {
  WavePoint point = four_waves(x, z, time, 0.2);
  return component_of(x, z, point, exact_normal(point), component);
}
float gems_gerstner(float x, float z, float time, float component) {
  WavePoint point = four_waves(x, z, time, 0.2);
  return component_of(x, z, point, gems_normal(point), component);
}
float sine_gerstner(float x, float z, float time, float component) {
  WavePoint point = four_waves(x, z, time, 0.0);
  return component_of(x, z, point, sine_normal(point), component);
}

// By the function that GERSTNER names.
float gerstner(float x, float z, float time, float component) { return GERSTNER(x, z, time, component); }
