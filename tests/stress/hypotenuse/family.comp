// SPDX-License-Identifier: Apache-2.0
#include "hypotenuse.glsl"
#include "stress/function.glsl"
