// SPDX-License-Identifier: Apache-2.0
// Sheets of still water at y = 0 that waves can bend, seen from above, with edges short enough for the waves: four to the
// shortest wave that is drawn. Their numbers grid_spacing and grid_growth tell shaders how long edges are.
#pragma once

#include <glm/glm.hpp>

#include "harness/scene/scene.h"

namespace lamina {

// Between two corners (x, z), with edges of `spacing_m` at most.
Mesh water_rectangle(glm::vec2 low, glm::vec2 high, float spacing_m);

// A disc around the origin. Edges are `spacing_m` long, and from where growth times the distance is more, that: a picture from
// over the middle sees them all about as long. growth: 0.01 to 0.5.
Mesh water_disc(float radius_m, float spacing_m, float growth);

// An object that is water, of such a mesh. `scene` is told how fine the mesh is.
Object water_object(Scene& scene, Mesh mesh, float spacing_m, float growth);

// What [effects.water] says of a wave, 1 to 4.
struct MadeWave {
  double amplitude_m, length_m, direction_degrees, steepness;
};
void set_wave(Scene& scene, int wave, const MadeWave& made);

}  // namespace lamina
