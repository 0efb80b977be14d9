// SPDX-License-Identifier: Apache-2.0
// What two spherical caps share, to the last bit of a double; what harness/effects/cap_intersection/cap_area.h is held to.
#pragma once

namespace lamina {

// The Gauss-Bonnet lens with three arc cosines, in 400 bits, so that its cancellations do not reach a double. Angular radii r0,
// r1 and distance d of the centres in radians, area in steradians. About a third of a millisecond. Throws Error(bad_input) for
// what are_caps() is false for.
double cap_intersection_oracle(double r0, double r1, double d);

}  // namespace lamina
