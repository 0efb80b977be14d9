// SPDX-License-Identifier: Apache-2.0
// With the slide's luminance, whose weights sum to 1.03, and its bare powers.
float powers_printed(float s, float px, float py, float amount) {
  vec2 sharp = vec2(pow(s, px), pow(s, py));
  float red = mix(sharp.y, sharp.x, amount), rest = mix(sharp.y, sharp.x, 0.5 * amount);
  return clamp(mix(red, 0.33 * red + 0.59 * rest + 0.11 * rest, 0.75), 0.0, 1.0);
}
