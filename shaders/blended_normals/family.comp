// SPDX-License-Identifier: Apache-2.0
#include "blended_normals.glsl"
#include "stress/function.glsl"
