// SPDX-License-Identifier: Apache-2.0
// What two spherical caps share, as a reference for the shaders' approximations.
// Angular radii r0, r1 in (0, pi], distance of the centres d in [0, pi], in radians (pi may be binary32's, which is above it);
// areas in steradians on the unit sphere.
#pragma once

namespace lamina {

// Whether these are radii and a distance: finite, and in the ranges above.
bool are_caps(double r0, double r1, double d);

// In double: two circular segments (see shaders/cap_intersection/exact_cap.glsl). Within 4 eps max(1, kappa) of the oracle
// (harness/effects/cap_intersection/cap_oracle.h), relative; eps = 2^-52. The arguments are not checked.
double cap_intersection_area(double r0, double r1, double d);

// Area of the smaller cap.
double smaller_cap_area(double r0, double r1);

// How much relative errors of the arguments are amplified: the sum over arguments of |argument * derivative / area|, with the
// derivatives d/dr0 = 2 A sin r0, d/dr1 = 2 B sin r1, d/dd = -2 sin r0 sin A; 0 where the caps are apart.
// `area` is cap_intersection_area() of the same.
double cap_intersection_condition(double r0, double r1, double d, double area);

}  // namespace lamina
