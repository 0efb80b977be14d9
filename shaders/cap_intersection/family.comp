// SPDX-License-Identifier: Apache-2.0
#include "cap_intersection.glsl"
#include "stress/function.glsl"
