// SPDX-License-Identifier: Apache-2.0
#include "transmittance.glsl"
#include "stress/function.glsl"
