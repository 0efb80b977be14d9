// SPDX-License-Identifier: Apache-2.0
// What a scene says of all its fog.
#ifndef FOG_NUMBERS_GLSL
#define FOG_NUMBERS_GLSL
layout(std140, binding = 3) uniform Effect {
  float density;      // 1/m
  float ramp_length;  // m
  float reach;        // m of view depth that codes reach; 0: the far plane
};
#endif
