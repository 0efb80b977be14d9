// SPDX-License-Identifier: Apache-2.0
#include "burley_radius.glsl"
#include "stress/function.glsl"
