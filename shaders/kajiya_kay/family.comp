// SPDX-License-Identifier: Apache-2.0
#include "kajiya_kay.glsl"
#include "stress/function.glsl"
