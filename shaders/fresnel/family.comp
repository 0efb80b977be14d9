// SPDX-License-Identifier: Apache-2.0
#include "fresnel.glsl"
#include "stress/function.glsl"
