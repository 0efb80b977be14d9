// SPDX-License-Identifier: Apache-2.0
// Makes the table that transmittance_table.glsl reads.
#include "common/frame.glsl"
#include "air.glsl"
#include "sun_path.glsl"
#include "transmittance_table.glsl"
layout(location = 0) out vec4 out_transmittance;

void main() {
  vec2 place = (gl_FragCoord.xy - 0.5) / (vec2(TABLE_WIDTH, TABLE_HEIGHT) - 1.0);
  float furthest = sqrt(greatest_excess()), horizon = place.y * furthest, excess = horizon * horizon;
  float altitude = excess / (sqrt(planet_radius * planet_radius + excess) + planet_radius);
  float least = top - altitude, distance = least + place.x * (horizon + furthest - least);
  // The direction that is so far from the top; straight up at it.
  float half_linear = (greatest_excess() - excess - distance * distance) / (2.0 * max(distance, 1e-3));
  float upwards = clamp(half_linear / (planet_radius + altitude), -1.0, 1.0);
  AirRay ray = AirRay(vec3(0.0, altitude, 0.0), vec3(sqrt(1.0 - upwards * upwards), upwards, 0.0), half_linear, excess);
  out_transmittance = vec4(transmittance_of_path(ray), 1.0);
}
