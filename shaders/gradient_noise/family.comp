// SPDX-License-Identifier: Apache-2.0
#include "gradient_noise.glsl"
#include "stress/function.glsl"
