// SPDX-License-Identifier: Apache-2.0
// The first direction of a separable blur in screen space (J. Jimenez and others, "Separable Subsurface Scattering", 2015):
// along x. A tap that does not count is replaced by the middle.
#define FRAME_MEMBERS mat4 clip_from_view;
#include "../common/frame.glsl"
#include "channel_taps.glsl"
#include "screen_light.glsl"
#include "screen_blur.glsl"

layout(location = 0) out vec4 out_blurred;

void main() {
  ScreenPlace place = screen_place();
  out_blurred = vec4(screen_blur(place, vec2(1.0, 0.0)), 1.0);
}
