// SPDX-License-Identifier: Apache-2.0
#include "beckmann.glsl"
#include "stress/function.glsl"
