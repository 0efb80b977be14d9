// SPDX-License-Identifier: Apache-2.0
#include "thickness_ramp.glsl"
#include "stress/function.glsl"
