// SPDX-License-Identifier: Apache-2.0
#include "rgbm8.glsl"
#include "stress/function.glsl"
