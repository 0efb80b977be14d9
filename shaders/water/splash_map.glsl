// SPDX-License-Identifier: Apache-2.0
// The square of water on which waves run that objects throw back: splash_size wide, before the eye, at whole texels of the world, so
// that nothing swims with the eye.
const float splash_side = 256.0;

vec2 splash_middle() {
  vec4 ahead = world_from_clip * vec4(0.0, 0.0, 1.0, 1.0);
  vec2 direction = ahead.xz / ahead.w - eye_world.xz;
  direction /= max(length(direction), 1e-6);
  // Looking down, the middle is under the eye.
  vec3 whole = normalize(ahead.xyz / ahead.w - eye_world.xyz);
  vec2 middle = eye_world.xz + 0.4 * splash_size * length(whole.xz) * direction;
  float texel = splash_size / splash_side;
  return round(middle / texel) * texel;
}
// From x and z to the map's 0 to 1, and back.
vec2 splash_place(vec2 at) { return (at - splash_middle()) / splash_size + 0.5; }
vec2 splash_ground(vec2 place) { return (place - 0.5) * splash_size + splash_middle(); }

// 1 but for the outer fifth of each half, where it falls to 0.
float splash_fade(vec2 place) {
  vec2 off = abs(2.0 * place - 1.0);
  return 1.0 - smoothstep(0.8, 1.0, max(off.x, off.y));
}
