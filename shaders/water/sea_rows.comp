// SPDX-License-Identifier: Apache-2.0
// The spectrum of the scene's waves on a tile, and its inverse transform along rows. Eight real fields in four complex ones: height and
// movement along x; movement along z and how that along x changes with z; the slopes; how movements change along themselves. After
// Tessendorf, "Simulating Ocean Water", 2001, with Gerstner's movements, whose swing each wave says, and slopes by the spectrum.
#include "effect.glsl"
#include "sea_tile.glsl"
#include "fft_256.glsl"

layout(binding = 4, rgba32f) uniform writeonly image2D shape_rows;
layout(binding = 5, rgba32f) uniform writeonly image2D slope_rows;

// Half of s sin + c cos at a turn, as the number at its wave vector has it; at the opposite one it is the conjugate.
vec2 half_wave(float s, float c, vec2 turn) { return 0.5 * complex_product(vec2(c, -s), turn); }
// Two real fields in one complex one.
vec2 pair_of(vec2 a, vec2 b, float side) { return vec2(a.x - side * b.y, side * a.y + b.x); }

void add_mode(inout vec4 shape, inout vec4 slopes, ivec2 mode, float amplitude, float wave_length, float degrees, float steepness) {
  if (amplitude <= 0.0) return;
  float tile = sea_tile_m();
  vec2 whole = round(tile / wave_length * vec2(cos(radians(degrees)), sin(radians(degrees))));
  whole = clamp(whole, vec2(-120.0), vec2(120.0));
  if (dot(whole, whole) < 0.5) whole.x = 1.0;
  float side = mode == ivec2(whole) ? 1.0 : mode == -ivec2(whole) ? -1.0 : 0.0;
  if (side == 0.0) return;
  vec2 k = 6.28318531 / tile * whole, along = normalize(k);
  float number = length(k), reach = steepness * wave_length / 6.28318531;
  float slowed = wave_depth > 0.0 ? tanh(min(number * wave_depth, 20.0)) : 1.0;
  float turn = 6.28318531 * fract(eye_world.w * sqrt(9.81 * number * slowed) / 6.28318531);
  vec2 at = vec2(cos(turn), sin(turn)), swing = reach * along;
  shape.xy += pair_of(half_wave(amplitude, 0.0, at), half_wave(0.0, swing.x, at), side);
  shape.zw += pair_of(half_wave(0.0, swing.y, at), half_wave(-swing.x * k.y, 0.0, at), side);
  slopes.xy += pair_of(half_wave(0.0, amplitude * k.x, at), half_wave(0.0, amplitude * k.y, at), side);
  slopes.zw += pair_of(half_wave(-swing.x * k.x, 0.0, at), half_wave(-swing.y * k.y, 0.0, at), side);
}

void main() {
  uint row = gl_WorkGroupID.y;
  float steep = (wave_1_amplitude > 0.0 ? wave_1_steepness : 0.0) + (wave_2_amplitude > 0.0 ? wave_2_steepness : 0.0) +
                (wave_3_amplitude > 0.0 ? wave_3_steepness : 0.0) + (wave_4_amplitude > 0.0 ? wave_4_steepness : 0.0);
  steep = 1.0 / max(steep, 1.0);
  for (uint i = gl_LocalInvocationID.x; i < fft_side; i += 128u) {
    // The second half of the numbers are waves of the opposite side.
    ivec2 mode = ivec2(int(i), int(row));
    mode -= ivec2(fft_side) * ivec2(greaterThanEqual(mode, ivec2(fft_side / 2u)));
    vec4 shape = vec4(0.0), slopes = vec4(0.0);
    add_mode(shape, slopes, mode, wave_1_amplitude, wave_1_length, wave_1_direction, steep * wave_1_steepness);
    add_mode(shape, slopes, mode, wave_2_amplitude, wave_2_length, wave_2_direction, steep * wave_2_steepness);
    add_mode(shape, slopes, mode, wave_3_amplitude, wave_3_length, wave_3_direction, steep * wave_3_steepness);
    add_mode(shape, slopes, mode, wave_4_amplitude, wave_4_length, wave_4_direction, steep * wave_4_steepness);
    fft_first[i] = shape, fft_second[i] = slopes;
  }
  fft_256();
  for (uint i = gl_LocalInvocationID.x; i < fft_side; i += 128u) {
    imageStore(shape_rows, ivec2(i, row), fft_first[i]);
    imageStore(slope_rows, ivec2(i, row), fft_second[i]);
  }
}
