// SPDX-License-Identifier: Apache-2.0
// What the water and the sky above it do to light. Light is in the unit of lights: a white surface shows its irradiance, pi times
// its radiance.
#include "fresnel/exact_fresnel.glsl"
#include "water_in_scatter/water_in_scatter.glsl"

layout(binding = 10) uniform sampler2D sky;

const float sky_cosine = 0.83;      // of the sky's light in water: its mean way down is 1 / 0.83 of the depth
const float sky_passes = 0.9336;    // of the sky's light into water: 1 less the mean of Fresnel's share

// What a ray sees that meets nothing.
vec3 sky_seen(vec3 direction) {
#ifdef SKY
  return sky_light * textureLod(sky, vec2(sqrt(clamp(direction.y, 0.0, 1.0)), 0.5), 0.0).rgb;
#else
  return background.rgb;
#endif
}

vec3 absorption() { return vec3(absorption_red, absorption_green, absorption_blue); }
#ifdef SCATTERING
vec3 scattered() { return scattering * vec3(scattering_red, scattering_green, scattering_blue); }
#else
vec3 scattered() { return vec3(0.0); }
#endif
vec3 extinction() { return absorption() + scattered(); }

// The sun is the first light, if it is directional; under the horizon it is none.
bool is_sunlit() { return light_count.x > 0 && light_position[0].w == 0.0 && light_position[0].y > 0.0; }
// Towards it, under water: unit.
vec3 sun_in_water() {
  vec3 to_sun = is_sunlit() ? light_position[0].xyz : vec3(0, 1, 0);
  vec2 across = to_sun.xz / refraction_index;
  return vec3(across.x, sqrt(1.0 - dot(across, across)), across.y);
}
// Its irradiance under the surface, on a plane that faces it.
vec3 sunlight_in_water() {
  if (!is_sunlit()) return vec3(0.0);
  float cosine = light_position[0].y;
  return light_radiance[0].rgb * (1.0 - exact_fresnel(cosine, refraction_index)) * cosine / sun_in_water().y;
}

// Henyey and Greenstein, times 4 pi.
float phase(float cosine) {
  float base = 1.0 + scattering_g * scattering_g - 2.0 * scattering_g * cosine;
  return (1.0 - scattering_g * scattering_g) / (base * sqrt(base));
}

// What a way in the water, of this length from the surface, adds: sun and sky, scattered once. `into`: unit, down the way.
vec3 in_scatter(vec3 into, float way_m) {
#if defined(SCATTERING) && !defined(NO_IN_SCATTER)
  float down = max(-into.y, 0.0);
  vec3 sun = sun_in_water(), c = extinction(), lengths, sky_lengths;
  for (int i = 0; i < 3; ++i) {
    lengths[i] = IN_SCATTER(c[i], way_m, down, sun.y);
    sky_lengths[i] = IN_SCATTER(c[i], way_m, down, sky_cosine);
  }
  return scattered() * (0.25 * phase(dot(into, -sun)) * sunlight_in_water() * lengths + 0.5 * sky_passes * ambient.rgb * sky_lengths);
#else
  return vec3(0.0);
#endif
}
