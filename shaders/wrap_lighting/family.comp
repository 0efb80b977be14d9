// SPDX-License-Identifier: Apache-2.0
#include "wrap_lighting.glsl"
#include "stress/function.glsl"
