// SPDX-License-Identifier: Apache-2.0
// Many rays, each reflected by a microfacet of its own, and the mirror's picture at full resolution where each lands. A facet
// counts by how much of it the eye sees (Heitz, JCGT 3(2), 2014, without masking): its projected area over that of the surface.
// What lies before the surface is not reflected by it: rays that land there are left out.
#include "facets.glsl"
#include "dither/dither.glsl"

layout(binding = 5) uniform sampler2D reflection;
layout(location = 0) out vec4 out_color;

void main() {
  SurfacePoint at = surface_point();
  vec3 to_eye = normalize(eye_world.xyz - at.position);
  LeavingRay straight = reflected_by(at, to_eye, vec2(0.0));
  float own_depth = view_depth_of(at.position), start = max(depth_at(own_place()), own_depth), eye_cosine = dot(at.normal, to_eye);
  vec3 reflected = textureLod(reflection, landing(straight, start), 0.0).rgb * reflected_share(eye_cosine);
#ifdef ROUGH
  // Slopes by equal shares of the distribution, on a spiral of the golden angle that is turned from pixel to pixel.
  float slope = roughness * roughness, turn = 6.2831853 * gradient_noise(gl_FragCoord.xy), rays = 0.0;
  float eye_sine = sqrt(max(1.0 - eye_cosine * eye_cosine, 0.0));
  vec3 sum = vec3(0.0);
  for (int i = 0; i < SAMPLES; ++i) {
    float angle = turn + 2.39996323 * float(i), radius = slope * sqrt(-log(1.0 - (float(i) + 0.5) / float(SAMPLES)));
    vec2 slopes = radius * vec2(cos(angle), sin(angle));
    LeavingRay ray = reflected_by(at, to_eye, slopes);
    vec2 uv = landing(ray, start);
    float seen = max(eye_cosine + slopes.x * eye_sine, 0.0), facet_cosine = seen * inversesqrt(1.0 + dot(slopes, slopes));
    // No branch around the look-ups: lavapipe 22.3 crashes on uniforms that are read in one.
    float counts = (ray.passes ? seen : 0.0) * step(own_depth, depth_at(uv));
    sum += counts * reflected_share(facet_cosine) * textureLod(reflection, uv, 0.0).rgb;
    rays += counts;
  }
  if (rays > 0.0) reflected = sum / rays;
#endif
  out_color = vec4(light_of_surface(at, to_eye, reflected), 1.0);
}
