// SPDX-License-Identifier: Apache-2.0
// Gerstner's waves: P = (g + sum R D cos a, sum A sin a), a = 2 pi / L D.g + f t (Gerstner 1802, as Finch writes it in "Effective
// Water Simulation from Physical Models", GPU Gems, 2004, chapter 1, with the 2 pi of the wave number that its text has lost).
#ifndef GERSTNER_GLSL
#define GERSTNER_GLSL
#include "../wave_phase/wave_phase.glsl"

const float two_pi = 6.28318531;

struct Wave {
  float amplitude, wave_length;  // metres
  vec2 from;                     // unit: where it comes from
  float steepness;               // 2 pi / length times the reach of its points
};

// Of a point of the surface: where it is moved to, and what of its tangents is not the plane's.
struct WavePoint {
  vec3 offset, along_x, along_z;
};

// Waves a second: deep water's, or that over a bottom (0: deep).
float waves_per_second(float wave_length, float depth) {
  float slowed = depth > 0.0 ? tanh(min(two_pi * depth / wave_length, 20.0)) : 1.0;
  return sqrt(9.81 / (two_pi * wave_length) * slowed);
}

void add_wave(inout WavePoint point, Wave wave, vec2 ground, float time, float depth, float share) {
  float time_waves = fract(time * waves_per_second(wave.wave_length, depth));
  float turn = two_pi * (remaining_waves(dot(wave.from, ground), wave.wave_length) + time_waves);
  float sine = sin(turn), cosine = cos(turn), number = two_pi / wave.wave_length;
  float reach = share * wave.steepness / number, amplitude = share * wave.amplitude;
  point.offset += vec3(reach * wave.from.x * cosine, amplitude * sine, reach * wave.from.y * cosine);
  vec3 slope = number * vec3(-reach * wave.from.x * sine, amplitude * cosine, -reach * wave.from.y * sine);
  point.along_x += wave.from.x * slope;
  point.along_z += wave.from.y * slope;
}

// The cross product of the tangents.
vec3 exact_normal(WavePoint point) { return normalize(cross(vec3(0, 0, 1) + point.along_z, vec3(1, 0, 0) + point.along_x)); }
// The chapter's equation 12, which leaves out the products between waves.
vec3 gems_normal(WavePoint point) {
  return normalize(vec3(-point.along_x.y, 1.0 + point.along_x.x + point.along_z.z, -point.along_z.y));
}
// As if points moved up and down alone.
vec3 sine_normal(WavePoint point) { return normalize(vec3(-point.along_x.y, 1.0, -point.along_z.y)); }
#endif
