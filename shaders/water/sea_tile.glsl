// SPDX-License-Identifier: Apache-2.0
// The tile of water that the transform makes: four of the longest wave along its side. Waves are bent and stretched so that whole
// ones fit on it, by an eighth of the longest at most.
float longer_wave(float longest, float amplitude, float wave_length) { return amplitude > 0.0 ? max(longest, wave_length) : longest; }
float sea_tile_m() {
  float longest = longer_wave(longer_wave(0.0, wave_1_amplitude, wave_1_length), wave_2_amplitude, wave_2_length);
  longest = longer_wave(longer_wave(longest, wave_3_amplitude, wave_3_length), wave_4_amplitude, wave_4_length);
  return longest > 0.0 ? 4.0 * longest : 1.0;
}
