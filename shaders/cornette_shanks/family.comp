// SPDX-License-Identifier: Apache-2.0
#include "cornette_shanks.glsl"
#include "stress/function.glsl"
