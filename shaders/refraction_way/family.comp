// SPDX-License-Identifier: Apache-2.0
#include "refraction_way.glsl"
#include "stress/function.glsl"
