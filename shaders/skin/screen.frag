// SPDX-License-Identifier: Apache-2.0
// Skin on screen, its light diffused from the light buffer by DIFFUSED, which is separable_light, nine_taps or burley_taps.
#include "material.glsl"
#include "soft_shadow.glsl"
#include "surface_light.glsl"
#include "screen_light.glsl"
#include "../burley_radius/burley_series.glsl"
#include "../common/extra_fetches.glsl"

layout(location = 0) out vec4 out_color;

#ifdef HALF_TAPS
#include "channel_taps.glsl"
#include "screen_blur.glsl"
layout(binding = 13) uniform sampler2D unblurred;
// The second direction; the narrowest Gaussian's light stays where it is.
vec3 separable_light(ScreenPlace place) {
  vec3 first = texelFetch(unblurred, ivec2(place.pixel), 0).rgb;
  return mix(screen_blur(place, vec2(0.0, 1.0)), first, profile_weight(0));
}
#endif

// A share of a pixel's own; the same in every frame.
float pixel_noise() { return random_of(uvec3(gl_FragCoord.xy, 7u)); }

// The profile at a squared distance, without the narrowest Gaussian.
vec3 rest_of_profile(float squared) {
  vec3 sum = vec3(0.0);
  for (int i = 1; i < 6; ++i)
    sum += profile_weight(i) * exp(-0.5 * squared / profile_variance(i)) / (6.2831853 * profile_variance(i));
  return sum;
}

#ifdef TAPS
// Drobot's taps ("Skin rendering", 2011), here spread over a disc by equal shares of a heavy-tailed radius and turned by
// another angle in every pixel; a tap far out reads a smaller level of the light buffer.
vec3 nine_taps(ScreenPlace place) {
  vec3 middle = textureLod(light_buffer, place.pixel * frame_size_px.zw, 0.0).rgb, sum = vec3(0.0), weights = vec3(0.0);
  float noise = pixel_noise(), spread = 2.0 * sigma_4, turn = 6.2831853 * noise;
  for (int i = 0; i < TAPS; ++i) {
    float share = (float(i) + 0.25 + 0.5 * noise) / float(TAPS), left = 1.0 - 0.92 * share;
    float squared = spread * spread * share * share / left, area = spread * spread * share * (2.0 - 0.92 * share) / (left * left);
    float angle = turn + 2.39996323 * float(i), level = max(log2(0.5 * sqrt(squared) * place.pixels_a_mm.y), 0.0);
    vec4 tap = light_tap(place, sqrt(squared) * vec2(cos(angle), sin(angle)), min(level, 2.0));
    vec3 weight = rest_of_profile(squared) * area;
    sum += weight * tap.rgb, weights += weight * tap.a;
  }
  return mix(sum / max(weights, 1e-5), middle, profile_weight(0));
}

// Burley's profile, one width a channel, sampled by its closed inverse for red; the widths are those that fit d'Eon and
// Luebke's skin, scaled by the profile's.
vec3 burley_profile(float r, vec3 d) { return (exp(-r / d) + exp(-r / (3.0 * d))) / (25.1327412 * d * r); }
vec3 burley_taps(ScreenPlace place) {
  vec3 d = vec3(0.411, 0.119, 0.081) * sqrt(mean_variance() / vec3(1.38287, 0.06813, 0.02477));
  vec3 sum = vec3(0.0), weights = vec3(0.0);
  float turn = 6.2831853 * pixel_noise();
  for (int i = 0; i < TAPS; ++i) {
    float r = d.r * burley_series((float(i) + 0.5) / float(TAPS)), angle = turn + 2.39996323 * float(i);
    vec4 tap = light_tap(place, r * vec2(cos(angle), sin(angle)), 0.0);
    vec3 weight = burley_profile(r, d) / burley_profile(r, vec3(d.r)).r;
    sum += weight * tap.rgb, weights += weight * tap.a;
  }
  return sum / max(weights, 1e-5);
}
#endif

void main() {
  SkinPoint point = skin_point();
  vec2 map = specular_map(point.uv);
  vec3 to_eye = normalize(eye_world.xyz - point.position);
  vec3 color = DIFFUSED(screen_place()) * sqrt(point.albedo) * entering(dot(point.normal, to_eye), map);
#if defined(SPECULAR) || defined(OIL) || defined(RIM) || defined(BACK_SCATTERING)
  for (int i = 0; i < light_count.x; ++i) {
    ArrivingLight light = arriving_light(i, point.position);
    float lit = soft_shadow(i, point.position, point.smooth_normal, light.direction);
    color += light.irradiance * (lit * highlight(point, map, light.direction, to_eye));
    color += light.irradiance * back_scattered(point, light.direction);
  }
#endif
  out_color = vec4(color, 1.0);
#ifdef LAMINA_EXTRA_FETCHES
  out_color += extra_fetches(skin_albedo);
#endif
}
