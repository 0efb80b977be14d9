// SPDX-License-Identifier: Apache-2.0
// See day.h.
#include "harness/scene/made/day.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lamina {
namespace {

// A mountain range of the temperate zone in early May.
const double latitude = glm::radians(44.0), declination = glm::radians(16.0);
constexpr double noon_s = 6.1;

// The sun at the zenith outside the air, and the optical depth of the air over a point by red, green and blue: after Rayleigh
// scattering and some haze, weakened so that a rising sun still lights the land.
constexpr glm::vec3 above_air{1.55f, 1.58f, 1.66f}, optical_depth{0.038f, 0.076f, 0.150f};

struct Sky {
  float elevation_degrees;  // the sun's
  glm::vec3 ambient, background;
};
// Night, dusk, an hour of low sun, day; linear in between.
constexpr std::array<Sky, 5> skies = {{{-14, {0.010f, 0.013f, 0.024f}, {0.003f, 0.005f, 0.012f}},
                                       {-4, {0.050f, 0.048f, 0.075f}, {0.080f, 0.060f, 0.090f}},
                                       {2, {0.135f, 0.115f, 0.130f}, {0.450f, 0.290f, 0.220f}},
                                       {10, {0.180f, 0.205f, 0.265f}, {0.400f, 0.500f, 0.640f}},
                                       {35, {0.190f, 0.230f, 0.310f}, {0.300f, 0.470f, 0.720f}}}};

}  // namespace

float air_mass(float elevation_degrees) {
  const float h = std::max(elevation_degrees, 0.0f);
  return 1 / (std::sin(glm::radians(h)) + 0.50572f * std::pow(h + 6.07995f, -1.6364f));
}

Daylight daylight(float time_s) {
  const double days = (time_s - noon_s) / day_s, hour_angle = 2 * M_PI * (days - std::floor(days));
  const double sin_d = std::sin(declination), cos_d = std::cos(declination);
  const double sin_l = std::sin(latitude), cos_l = std::cos(latitude);
  Daylight day;
  // The hour angle grows westwards.
  day.to_sun = glm::normalize(glm::dvec3(-cos_d * std::sin(hour_angle), sin_l * sin_d + cos_l * cos_d * std::cos(hour_angle),
                                         sin_l * cos_d * std::cos(hour_angle) - cos_l * sin_d));
  const float elevation = glm::degrees(std::asin(std::clamp(day.to_sun.y, -1.0f, 1.0f)));
  // The disc rises: none of it at -radius; full where dust and distance hide the horizon no more.
  const float risen = glm::smoothstep(-day_sun_radius_degrees, 2 * day_sun_radius_degrees, elevation);
  day.radiance = risen * above_air * glm::exp(-optical_depth * air_mass(elevation));

  const auto next =
      std::find_if(skies.begin() + 1, skies.end() - 1, [&](const Sky& s) { return s.elevation_degrees > elevation; });
  const Sky &low = *(next - 1), &high = *next;
  const float t =
      std::clamp((elevation - low.elevation_degrees) / (high.elevation_degrees - low.elevation_degrees), 0.0f, 1.0f);
  day.ambient = glm::mix(low.ambient, high.ambient, t);
  day.background = glm::mix(low.background, high.background, t);
  return day;
}

}  // namespace lamina
