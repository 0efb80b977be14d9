// SPDX-License-Identifier: Apache-2.0
#include "back_light.glsl"
#include "stress/function.glsl"
