// SPDX-License-Identifier: Apache-2.0
// The scene's waves. WAVES: how many of them at most, the first ones; SINES: their points move up and down alone; FFT: as a tile has
// them that a Fourier transform made.
#include "gerstner/gerstner.glsl"

#ifndef WAVES
#define WAVES 4
#endif

Wave wave_of(float amplitude, float wave_length, float degrees, float steepness) {
  return Wave(amplitude, wave_length, vec2(cos(radians(degrees)), sin(radians(degrees))), steepness);
}

// Steepnesses are shrunk to a sum of 1, so that nothing folds.
float steepness_share() {
  float sum = 0.0;
#ifdef WAVE_1
  sum += wave_1_steepness;
#endif
#ifdef WAVE_2
  sum += wave_2_steepness;
#endif
#ifdef WAVE_3
  sum += wave_3_steepness;
#endif
#ifdef WAVE_4
  sum += wave_4_steepness;
#endif
#ifdef SINES
  return 0.0;
#else
  return 1.0 / max(sum, 1.0);
#endif
}

#ifdef SHORE
layout(binding = 12) uniform sampler2D bottom;
float bottom_at(vec2 ground) { return bottom_depth * textureLod(bottom, ground / bottom_width + 0.5, 0.0).r; }
#endif

// Over a bottom that is less deep than half the wave, less of it is left. `depth`: and its slopes along x and z.
vec3 shore_share(vec3 depth, float wave_length) {
  float t = clamp(2.0 * depth.x / wave_length, 0.0, 1.0);
  return vec3(t * t * (3.0 - 2.0 * t), 12.0 * t * (1.0 - t) / wave_length * depth.yz);
}

// How much of a wave is drawn where details of this width are all that shows: edges of the mesh, or pixels.
float kept_share(float wave_length, float width) { return 1.0 - smoothstep(0.25, 0.5, width / wave_length); }

// How far the mesh has moved with the eye, by whole edges of its middle.
vec2 grid_moved() {
#ifdef GRID_FOLLOWS
  float whole = max(grid_spacing, 1e-3);
  return grid_follows * round(eye_world.xz / whole) * whole;
#else
  return vec2(0.0);
#endif
}

// Edges of the mesh here.
float grid_width(vec2 ground) { return grid_spacing + grid_growth * length(ground - grid_moved()); }

#ifdef FFT
#include "sea_point.glsl"
#endif

// The surface's point that lies at `ground` when there are no waves. `lost` gains the variance of slopes of what is left out.
WavePoint wave_point(vec2 ground, float width, inout float lost) {
  WavePoint point = WavePoint(vec3(0), vec3(0), vec3(0));
  float steep = steepness_share(), time = eye_world.w;
#ifdef SHORE
  float texel = bottom_width / float(textureSize(bottom, 0).x);
  vec3 depth = vec3(bottom_at(ground), bottom_at(ground + vec2(texel, 0)) - bottom_at(ground - vec2(texel, 0)),
                    bottom_at(ground + vec2(0, texel)) - bottom_at(ground - vec2(0, texel)));
  depth.yz /= 2.0 * texel;
#else
  const vec3 depth = vec3(1e9, 0, 0);
#endif
#ifdef FFT
  // All waves fade as the first does.
  vec3 first = shore_share(depth, wave_1_length);
  WavePoint sea = sea_point(ground);
  return WavePoint(first.x * sea.offset, first.x * sea.along_x + first.y * sea.offset, first.x * sea.along_z + first.z * sea.offset);
#endif
#define ADD_WAVE(a, l, d, s) \
  { \
    vec3 shore = shore_share(depth, l); \
    float share = kept_share(l, width), slope = two_pi / l * a * shore.x; \
    lost += 0.5 * slope * slope * (1.0 - share * share); \
    WavePoint whole = WavePoint(vec3(0), vec3(0), vec3(0)); \
    add_wave(whole, wave_of(a, l, d, s * steep), ground, time, wave_depth, share); \
    point.offset += shore.x * whole.offset; \
    point.along_x += shore.x * whole.along_x + shore.y * whole.offset; \
    point.along_z += shore.x * whole.along_z + shore.z * whole.offset; \
  }
#if defined(WAVE_1) && WAVES >= 1
  ADD_WAVE(wave_1_amplitude, wave_1_length, wave_1_direction, wave_1_steepness)
#endif
#if defined(WAVE_2) && WAVES >= 2
  ADD_WAVE(wave_2_amplitude, wave_2_length, wave_2_direction, wave_2_steepness)
#endif
#if defined(WAVE_3) && WAVES >= 3
  ADD_WAVE(wave_3_amplitude, wave_3_length, wave_3_direction, wave_3_steepness)
#endif
#if defined(WAVE_4) && WAVES >= 4
  ADD_WAVE(wave_4_amplitude, wave_4_length, wave_4_direction, wave_4_steepness)
#endif
  return point;
}
