// SPDX-License-Identifier: Apache-2.0
#include "kelemen_reflection.glsl"
#include "stress/function.glsl"
