// SPDX-License-Identifier: Apache-2.0
#include "water_in_scatter.glsl"
#include "stress/function.glsl"
