// SPDX-License-Identifier: Apache-2.0
// The formula of the slides, for air of one density under sunlight of one colour:
//   F_ex = e^-(bR + bM) s        L_in = (bR(theta) + bM(theta)) / (bR + bM) E_sun (1 - F_ex)
// (Hoffman and Preetham, "Rendering Outdoor Light Scattering in Real Time", GDC 2002, as James and Green cite it.)
// A solid thing is s metres away, through air as dense as at sea level. For the sky s is the depth of each kind of air straight
// up, times the relative optical mass of Preetham, Shirley and Smits, "A Practical Analytic Model for Daylight", SIGGRAPH 1999,
// appendix A.1 (after Kasten); so is the sun's own path, which gives E_sun at the ground. Ozone has no place in it.
#define FRAME_MEMBERS mat4 view_from_world, clip_from_view;
#include "common/frame.glsl"
#include "air.glsl"
#include "phase.glsl"
#include "seen_ray.glsl"
layout(binding = 4) uniform sampler2D frame;
layout(binding = 5) uniform sampler2D view_depth;
layout(location = 0) out vec4 out_color;

// Straight up 1, at the horizon 37.6; below it as at it.
float optical_mass(float upwards) {
  float cosine = clamp(upwards, 0.0, 1.0);
  return 1.0 / (cosine + 0.15 * pow(93.885 - degrees(acos(cosine)), -1.253));
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float along_axis, depth = texelFetch(view_depth, pixel, 0).r;
  AirRay ray = seen_ray(gl_FragCoord.xy, along_axis);
  vec3 to_sun = direction_to_sun();
  float cosine = dot(ray.direction, to_sun);
  vec2 straight_up = vec2(rayleigh_height, mie_height);
  vec2 path = depth < 1e29 ? vec2(depth * along_axis) : straight_up * optical_mass(ray.direction.y);
  vec3 molecules = rayleigh_scattering(), haze = vec3(0.0);
#ifdef HAZE
  haze = mie_extinction();
#endif
  vec3 passed = exp(-(molecules * path.x + haze * path.y));
  vec2 sun_path = straight_up * optical_mass(to_sun.y);
  // Below the horizon the formula knows no sun.
  vec3 sun = to_sun.y > 0.0 ? sun_above_air() * exp(-(molecules * sun_path.x + haze * sun_path.y)) : vec3(0.0);
  // Kinds of air weigh as they lie along the ray.
  vec3 into_ray = molecules * path.x * rayleigh_phase(cosine) + haze * path.y * mie_albedo * haze_phase(cosine, mie_g);
  vec3 light = 3.14159265 * sun * into_ray / max(molecules * path.x + haze * path.y, vec3(1e-20)) * (1.0 - passed);
  vec4 behind = texelFetch(frame, pixel, 0);
  out_color = vec4(behind.rgb * passed + light, behind.a);
}
