// SPDX-License-Identifier: Apache-2.0
#include "slab_in_scatter.glsl"
#include "stress/function.glsl"
