// SPDX-License-Identifier: Apache-2.0
#include "ward_reflection.glsl"
#include "stress/function.glsl"
