// SPDX-License-Identifier: Apache-2.0
// A face of a hull of fog, as every variant's fragment shaders take it: James, "Rendering Objects as Thick Volumes", in: ShaderX2,
// 2003. Thickness is the sum of back faces' depths less that of front faces', each cut at the nearest solid.

layout(std140, binding = 3) uniform Effect {
  int volume;   // 0 fog, 1 a hole: its faces count the other way round
  float share;  // of the fog's density, 0 to 1
  float reach;  // m of view depth that codes reach; 0: the far plane
};
layout(location = 0) in float in_view_depth;

// Whether the depth adds to the thickness: where a ray leaves fog, or enters a hole.
bool adds() { return gl_FrontFacing == (volume == 1); }
