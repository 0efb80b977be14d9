// SPDX-License-Identifier: Apache-2.0
// The block Effect of skin, and its diffusion profile as arrays: six Gaussians, from narrow to wide. Widths are in millimetres;
// in each channel the weights sum to 1.
#ifndef PROFILE_NUMBERS_GLSL
#define PROFILE_NUMBERS_GLSL

layout(std140, binding = 3) uniform Effect {
  float specular, roughness, reflectance, oil, oil_roughness, rim, rim_power;
  float melanin, back_scattering, diffusion, penumbra;
  float sigma_1, red_1, green_1, blue_1;
  float sigma_2, red_2, green_2, blue_2;
  float sigma_3, red_3, green_3, blue_3;
  float sigma_4, red_4, green_4, blue_4;
  float sigma_5, red_5, green_5, blue_5;
  float sigma_6, red_6, green_6, blue_6;
};

vec3 profile_weight(int i) {
  vec3 weights[6] = vec3[6](vec3(red_1, green_1, blue_1), vec3(red_2, green_2, blue_2), vec3(red_3, green_3, blue_3),
                            vec3(red_4, green_4, blue_4), vec3(red_5, green_5, blue_5), vec3(red_6, green_6, blue_6));
  return weights[i];
}

float profile_variance(int i) {  // mm^2
  float sigmas[6] = float[6](sigma_1, sigma_2, sigma_3, sigma_4, sigma_5, sigma_6);
  return sigmas[i] * sigmas[i];
}

// Mean variance of each channel, mm^2.
vec3 mean_variance() {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 6; ++i) sum += profile_weight(i) * profile_variance(i);
  return sum;
}

#endif
