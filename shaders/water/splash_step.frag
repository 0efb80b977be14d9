// SPDX-License-Identifier: Apache-2.0
// A step of the wave equation on the map, from still water some time ago to now: new = 2 h - before + (c dt / dx)^2 (neighbours - 4 h).
// In an object no water moves: there the waves that it throws back are the opposite of those that come. Half a texel a step, which is
// stable up to 0.707. In the outer fifth waves are damped, and are not thrown back from the edge.
#include "effect.glsl"
#include "splash_map.glsl"
#include "waves.glsl"

layout(binding = 4) uniform sampler2D splash_solid;
layout(binding = 5) uniform sampler2D before;  // height now and a step ago
layout(location = 0) out vec4 out_waves;

float shorter_wave(float shortest, float amplitude, float wave_length) { return amplitude > 0.0 ? min(shortest, wave_length) : shortest; }

// Height of one of the scene's waves, of still water's place.
float come(vec2 at, float time, float amplitude, float wave_length, float degrees) {
  if (amplitude <= 0.0) return 0.0;
  float turn = two_pi * (remaining_waves(dot(vec2(cos(radians(degrees)), sin(radians(degrees))), at), wave_length) +
                         fract(time * waves_per_second(wave_length, wave_depth)));
  return amplitude * sin(turn);
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy), last = textureSize(before, 0) - 1;
  float shortest = shorter_wave(shorter_wave(1e6, wave_1_amplitude, wave_1_length), wave_2_amplitude, wave_2_length);
  shortest = shorter_wave(shorter_wave(shortest, wave_3_amplitude, wave_3_length), wave_4_amplitude, wave_4_length);
  float speed = shortest * waves_per_second(shortest, wave_depth), texel = splash_size / splash_side, step_s = 0.5 * texel / speed;
  vec2 place = gl_FragCoord.xy / splash_side, state = iteration.x == 0 ? vec2(0.0) : texelFetch(before, at, 0).rg;
  float around = 0.0;
  if (iteration.x > 0)
    for (int side = 0; side < 4; ++side) {
      ivec2 step_texels = side < 2 ? ivec2(2 * side - 1, 0) : ivec2(0, 2 * side - 5);
      around += texelFetch(before, clamp(at + step_texels, ivec2(0), last), 0).r;
    }
  float next = 2.0 * state.x - state.y + 0.25 * (around - 4.0 * state.x);
  if (texelFetch(splash_solid, at, 0).r > 0.5) {
    float time = eye_world.w - step_s * float(iteration.y - 1 - iteration.x);
    vec2 ground = splash_ground(place);
    float sum = come(ground, time, wave_1_amplitude, wave_1_length, wave_1_direction);
    sum += come(ground, time, wave_2_amplitude, wave_2_length, wave_2_direction);
    sum += come(ground, time, wave_3_amplitude, wave_3_length, wave_3_direction);
    sum += come(ground, time, wave_4_amplitude, wave_4_length, wave_4_direction);
    // It starts slowly: a sudden start is a wave of its own.
    next = -sum * smoothstep(0.0, 0.25, float(iteration.x) / float(iteration.y));
  }
  vec2 off = abs(2.0 * place - 1.0);
  float damped = 1.0 - 0.1 * smoothstep(0.8, 1.0, max(off.x, off.y));
  out_waves = vec4(damped * next, damped * state.x, 0.0, 1.0);
}
