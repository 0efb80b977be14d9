// SPDX-License-Identifier: Apache-2.0
// What a scene file's [objects.NAME.aperture] says about baking an object's apertures: see scene.h's ApertureBake.
//
//   baker        "rays" | "spherical_harmonics"
//   map_texels   0 for a point a vertex, or the side of a map over the unwrap, 8 to 4096
//   rays         a point, 16 to 65536
//   seed         a whole number from 0 up
//   bias         metres above the surface at which rays start, above 0
#pragma once

#include "harness/core/toml_table.h"
#include "harness/scene/scene.h"

namespace lamina {

// `bake` with what the table changes. Throws Error(bad_input) with file and line.
ApertureBake read_aperture(const TomlTable& table, ApertureBake bake);

}  // namespace lamina
