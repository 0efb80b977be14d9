// SPDX-License-Identifier: Apache-2.0
// How the picture of what lies below lies around the frame: by GUARD times as wide, a tenth of the frame's height over it and
// GUARD_DOWN of it below. Rays that the water refracts bend down.
const vec2 below_first = vec2(0.5 - 0.5 * GUARD, -0.1), below_size = vec2(GUARD, 1.1 + GUARD_DOWN);

// From a place of the frame, 0 to 1, to the picture's.
vec2 below_place(vec2 place) { return (place - below_first) / below_size; }
