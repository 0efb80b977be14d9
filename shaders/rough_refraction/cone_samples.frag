// SPDX-License-Identifier: Apache-2.0
// Many rays through the slab, each by a microfacet of its own, and the picture at full resolution where each lands. What lies
// before the glass is not behind it: rays that land there are left out.
#include "slab.glsl"
#include "dither/dither.glsl"

layout(binding = 5) uniform sampler2D frame;
layout(location = 0) out vec4 out_color;

void main() {
  SurfacePoint at = surface_point();
  vec3 to_eye = normalize(eye_world.xyz - at.position);
  LeavingRay straight = through_slab(at, to_eye, vec2(0.0));
  float own_depth = view_depth_of(at.position), start = depth_at(own_place());
  vec3 centre = textureLod(frame, landing(straight, max(start, own_depth)), 0.0).rgb, behind = centre;
#ifdef ROUGH
  // Slopes by equal shares of Beckmann's distribution, on a spiral of the golden angle that is turned from pixel to pixel.
  float slope = roughness * roughness, turn = 6.2831853 * gradient_noise(gl_FragCoord.xy);
  vec3 sum = vec3(0.0);
  float rays = 0.0;
  for (int i = 0; i < SAMPLES; ++i) {
    float angle = turn + 2.39996323 * float(i), radius = slope * sqrt(-log(1.0 - (float(i) + 0.5) / float(SAMPLES)));
    LeavingRay ray = through_slab(at, to_eye, radius * vec2(cos(angle), sin(angle)));
    vec2 uv = landing(ray, max(start, own_depth));
    // No branch around the look-ups: lavapipe 22.3 crashes on uniforms that are read in one.
    float counts = (ray.passes ? 1.0 : 0.0) * step(own_depth, depth_at(uv));
    sum += counts * textureLod(frame, uv, 0.0).rgb;
    rays += counts;
  }
  if (rays > 0.0) behind = sum / rays;
#endif
  out_color = vec4(light_of_glass(at, to_eye, behind), 1.0);
}
