// SPDX-License-Identifier: Apache-2.0
#include "rayleigh.glsl"
#include "stress/function.glsl"
