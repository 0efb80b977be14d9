// SPDX-License-Identifier: Apache-2.0
#include "four_waves.glsl"
#include "stress/function.glsl"
