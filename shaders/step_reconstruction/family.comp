// SPDX-License-Identifier: Apache-2.0
#include "step_reconstruction.glsl"
#include "stress/function.glsl"
