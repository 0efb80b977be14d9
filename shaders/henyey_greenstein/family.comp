// SPDX-License-Identifier: Apache-2.0
#include "henyey_greenstein.glsl"
#include "stress/function.glsl"
