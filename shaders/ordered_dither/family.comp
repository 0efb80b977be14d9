// SPDX-License-Identifier: Apache-2.0
#include "ordered_dither.glsl"
#include "stress/function.glsl"
