// SPDX-License-Identifier: Apache-2.0
#include "shadow_powers.glsl"
#include "stress/function.glsl"
