// SPDX-License-Identifier: Apache-2.0
#include "wave_phase.glsl"
#include "stress/function.glsl"
