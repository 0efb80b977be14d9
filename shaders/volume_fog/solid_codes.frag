// SPDX-License-Identifier: Apache-2.0
// The view depth of a solid as a code of CODE_BITS bits a channel, n / 255.
#define FRAME_MEMBERS mat4 clip_from_view;
#include "../common/frame.glsl"
#include "../depth_encoding/codes.glsl"
#include "reach.glsl"

layout(std140, binding = 3) uniform Effect { float reach; };
layout(location = 0) in float in_view_depth;
layout(location = 0) out vec4 out_code;

void main() {
  uint code = code_of(in_view_depth / reached_m(reach), CODE_BITS);
  out_code = vec4(vec3(split_code(code, CODE_BITS)) / 255.0, 0.0);
}
