// SPDX-License-Identifier: Apache-2.0
#include "depth_sum.glsl"
#include "stress/function.glsl"
