// SPDX-License-Identifier: Apache-2.0
#include "gaussian_sum.glsl"
#include "stress/function.glsl"
