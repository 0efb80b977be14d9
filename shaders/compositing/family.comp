// SPDX-License-Identifier: Apache-2.0
#include "compositing.glsl"
#include "stress/function.glsl"
