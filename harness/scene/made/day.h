// SPDX-License-Identifier: Apache-2.0
// A day in 24 seconds: where the sun stands, and the light of sun and sky, so that shadows can be watched as they move.
// Sources: Meeus, "Astronomical Algorithms", 2nd ed., 1998, chapter 13 (the sun's place); Kasten and Young, "Revised optical
// air mass tables and approximation formula", Applied Optics 28, 1989 (how much air its light passes).
#pragma once

#include <glm/glm.hpp>

namespace lamina {

inline constexpr float day_s = 24;
// Seen from the ground. The real sun's is 0.2665 degrees; a larger one casts softer shadows that show at this scale.
inline constexpr float day_sun_radius_degrees = 2;

// Linear light, Rec. 709 primaries.
struct Daylight {
  glm::vec3 to_sun{0, 1, 0};  // unit; y up, x east, z south
  glm::vec3 radiance{0};      // the sun's irradiance at normal incidence; 0 where it is wholly below the horizon
  glm::vec3 ambient{0};       // the sky's irradiance
  glm::vec3 background{0};    // the sky's colour
};

// How many times as much air as straight up a light passes that stands so high over the horizon; below it as at it, about 38.
float air_mass(float elevation_degrees);

// Any finite time; days repeat. At 0 the sun stands 10 degrees high, noon is at 6.1 s, and it sets at 13.2 s.
Daylight daylight(float time_s);

}  // namespace lamina
