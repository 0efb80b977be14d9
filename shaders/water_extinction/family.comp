// SPDX-License-Identifier: Apache-2.0
#include "water_extinction.glsl"
#include "stress/function.glsl"
