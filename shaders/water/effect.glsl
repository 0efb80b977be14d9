// SPDX-License-Identifier: Apache-2.0
// What the effect declares: variants/water/effect.toml says what each number means.
#define FRAME_MEMBERS mat4 world_from_clip, mirror_clip_from_world; vec4 background;
#include "../common/frame.glsl"

layout(std140, binding = 3) uniform Effect {
  float height;
  float wave_1_amplitude, wave_1_length, wave_1_direction, wave_1_steepness;
  float wave_2_amplitude, wave_2_length, wave_2_direction, wave_2_steepness;
  float wave_3_amplitude, wave_3_length, wave_3_direction, wave_3_steepness;
  float wave_4_amplitude, wave_4_length, wave_4_direction, wave_4_steepness;
  float wave_depth, bottom_depth, bottom_width, ripples, ripple_size, dispersion, grid_spacing, grid_growth, refraction_index;
  float absorption_red, absorption_green, absorption_blue;
  float scattering, scattering_red, scattering_green, scattering_blue, scattering_g;
  float caustics, caustic_size, foam, foam_size, foam_height, foam_depth, soft_edge, specular, specular_width, sky_light;
  float splashes, splash_size, grid_follows;
};
