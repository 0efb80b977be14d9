// SPDX-License-Identifier: Apache-2.0
#include "mean_transmittance.glsl"
#include "stress/function.glsl"
