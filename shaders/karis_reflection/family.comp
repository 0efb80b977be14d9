// SPDX-License-Identifier: Apache-2.0
#include "karis_reflection.glsl"
#include "stress/function.glsl"
