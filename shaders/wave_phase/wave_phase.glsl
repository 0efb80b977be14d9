// SPDX-License-Identifier: Apache-2.0
// The sine of a wave's phase, x metres along it. Whole waves are taken off before the rest is turned into an angle, so far from
// the origin nothing but the rounding of x itself is left.
#ifndef WAVE_PHASE_GLSL
#define WAVE_PHASE_GLSL

// The product of two numbers less their rounded product `p`, exactly: each is cut into two halves of 12 bits (Dekker, "A
// Floating-Point Technique for Extending the Available Precision", Numerische Mathematik 18, 1971). Not every device fuses fma().
float lost_of_product(float a, float b, float p) {
  precise float ca = 4097.0 * a, a_high = ca - (ca - a), a_low = a - a_high;
  precise float cb = 4097.0 * b, b_high = cb - (cb - b), b_low = b - b_high;
  precise float lost = ((a_high * b_high - p) + a_high * b_low + a_low * b_high) + a_low * b_low;
  return lost;
}

// x in waves, less whole ones: about 0 to 1.
float remaining_waves(float x, float wave_length) {
  precise float whole = floor(x / wave_length), taken = whole * wave_length;
  precise float rest = (x - taken) - lost_of_product(whole, wave_length, taken);
  return rest / wave_length;
}
#ifdef WAVE_PHASE
float remainder_phase(float x, float wave_length) { return sin(6.28318531 * remaining_waves(x, wave_length)); }
// As waves are mostly written.
float plain_phase(float x, float wave_length) { return sin(6.28318531 / wave_length * x); }
// The place as a half float, as some compressed vertices hold it.
float half_phase(float x, float wave_length) {
  return sin(6.28318531 * remaining_waves(unpackHalf2x16(packHalf2x16(vec2(x, 0.0))).x, wave_length));
}

// By the function that WAVE_PHASE names.
float wave_phase(float x, float wave_length) { return WAVE_PHASE(x, wave_length); }
#endif
#endif
