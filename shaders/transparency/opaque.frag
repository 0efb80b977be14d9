// SPDX-License-Identifier: Apache-2.0
// An object of the effect whose opacity is 1 everywhere: a plain opaque surface.
#include "../common/frame.glsl"
#include "../common/surface.glsl"
#include "../common/mesh_in.glsl"
#include "surface.glsl"

layout(location = 0) out vec4 out_color;

void main() { out_color = vec4(shaded_surface().rgb, 1.0); }
