// SPDX-License-Identifier: Apache-2.0
// The two lights that matter most to an object: by the luminance that arrives at its middle, whichever way it faces. Of equal
// ones the first counts. -1 where there is no such light.

float arriving_luminance(int i, vec3 position) {
  vec3 to_light = light_position[i].xyz - position;
  float falloff = light_position[i].w > 0.0 ? 1.0 / max(dot(to_light, to_light), 1e-8) : 1.0;
  return dot(light_radiance[i].rgb, vec3(0.2126, 0.7152, 0.0722)) * falloff;
}

ivec2 influential_lights(vec3 middle) {
  ivec2 chosen = ivec2(-1);
  vec2 most = vec2(0.0);
  for (int i = 0; i < light_count.x; ++i) {
    float luminance = arriving_luminance(i, middle);
    if (luminance > most.x) {
      most = vec2(luminance, most.x);
      chosen = ivec2(i, chosen.x);
    } else if (luminance > most.y) {
      most.y = luminance;
      chosen.y = i;
    }
  }
  return chosen;
}
