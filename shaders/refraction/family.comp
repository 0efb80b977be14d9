// SPDX-License-Identifier: Apache-2.0
#include "refraction.glsl"
#include "stress/function.glsl"
