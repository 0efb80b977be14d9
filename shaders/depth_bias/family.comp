// SPDX-License-Identifier: Apache-2.0
#include "depth_bias.glsl"
#include "stress/function.glsl"
