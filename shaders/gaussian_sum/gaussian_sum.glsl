// SPDX-License-Identifier: Apache-2.0
// The profile by the function that GAUSSIAN_SUM names.
#include "burley_sum.glsl"
#include "one_gaussian_sum.glsl"
#include "six_gaussian_sum.glsl"
#include "two_gaussian_sum.glsl"

float gaussian_sum(float r) { return GAUSSIAN_SUM(r); }
