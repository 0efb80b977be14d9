// SPDX-License-Identifier: Apache-2.0
// Sine and arc tangent to within 2 units in the last place of binary32, however imprecise the device's own are: devices may err
// by 2^-11 (Khronos, Vulkan specification, "Precision and Operation of SPIR-V Instructions").
//
// Method: the Taylor series about 0 after an exact or two-part reduction of the argument; the first term left out is below
// 2^-27 of the result.
#ifndef PRECISE_MATH_GLSL
#define PRECISE_MATH_GLSL

const float half_pi_high = 1.57079637;        // the binary32 next to pi / 2
const float half_pi_low = -4.37113883e-8;     // pi / 2 - half_pi_high
const float tan_eighth_pi = 0.414213562;

// For |x| up to pi / 4.
float sine_near_zero(float x) {
  precise float q = x * x;
  precise float series = q * (-1.0 / 6.0 + q * (1.0 / 120.0 + q * (-1.0 / 5040.0 + q * (1.0 / 362880.0))));
  precise float result = x + x * series;
  return result;
}
float cosine_near_zero(float x) {
  precise float q = x * x;
  precise float result = 1.0 + q * (-0.5 + q * (1.0 / 24.0 + q * (-1.0 / 720.0 + q * (1.0 / 40320.0 - q * (1.0 / 3628800.0)))));
  return result;
}

// For x from 0 to pi.
float precise_sin(float x) {
  if (x <= 0.785398163) return sine_near_zero(x);
  precise float from_top = (x - half_pi_high) - half_pi_low;
  if (abs(from_top) <= 0.785398163) return cosine_near_zero(from_top);
  precise float from_pi = (2.0 * half_pi_high - x) + 2.0 * half_pi_low;
  return sine_near_zero(from_pi);
}

// atan(y / x) for y, x from 0 up, not both 0: from 0 to pi / 2.
float precise_atan2(float y, float x) {
  bool steep = y > x;
  precise float numerator = steep ? x : y;
  precise float denominator = steep ? y : x;
  precise float ratio = numerator / denominator;
  bool far = ratio > tan_eighth_pi;
  precise float t = far ? (numerator - denominator) / (numerator + denominator) : ratio;
  precise float q = t * t;
  precise float series = q * (-1.0 / 3.0 + q * (1.0 / 5.0 + q * (-1.0 / 7.0 + q * (1.0 / 9.0 + q * (-1.0 / 11.0 + q * (1.0 / 13.0 + q * (-1.0 / 15.0 + q * (1.0 / 17.0 + q * (-1.0 / 19.0)))))))));
  precise float angle = t + t * series;
  if (far) angle = 0.5 * half_pi_high + (0.5 * half_pi_low + angle);
  if (steep) angle = half_pi_high - (angle - half_pi_low);
  return angle;
}

#endif
