// SPDX-License-Identifier: Apache-2.0
vec3 screen_blur(ScreenPlace place, vec2 axis) {
  vec3 middle = texelFetch(light_buffer, ivec2(place.pixel), 0).rgb, sum = vec3(0.0);
  float reach = REACH();
  for (int i = 1; i <= HALF_TAPS; ++i) {
    vec2 off = axis * tap_place(i, reach);
    vec4 before = light_tap(place, -off, 0.0), after = light_tap(place, off, 0.0);
    sum += tap_weight(i, reach) * ((before.rgb - middle * before.a) + (after.rgb - middle * after.a));
  }
  return middle + sum;
}
