// SPDX-License-Identifier: Apache-2.0
#include "moment_transmittance.glsl"
#include "stress/function.glsl"
