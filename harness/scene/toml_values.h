// SPDX-License-Identifier: Apache-2.0
// Values of scene files in forms: vectors and colours.
#pragma once

#include "harness/core/toml_form.h"

namespace lamina {

inline constexpr double max_coordinate = 1e9;  // metres; squares of differences stay far inside a float's range
inline constexpr double max_radiance = 60000;  // a light's or a sky's strongest channel; half floats end at 65504

// [x, y, z]: metres, or a direction.
inline TomlValue vec3_value() { return form::numbers(-max_coordinate, max_coordinate, {3}); }
// [red, green, blue], linear, each from 0 to `max`.
inline TomlValue colour_value(double max) { return form::numbers(0, max, {3}); }

}  // namespace lamina
