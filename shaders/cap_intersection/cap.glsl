// SPDX-License-Identifier: Apache-2.0
// What the cap intersections share. Every one takes angular radii r0, r1 in (0, pi) and the distance d of the centres in [0,
// pi], in radians, and returns the area that both caps cover, in steradians.
#ifndef CAP_GLSL
#define CAP_GLSL

const float pi = 3.14159265;

// Area of a cap of angular radius r, without cancellation for small r.
float cap_area(float r) {
  float s = sin(0.5 * r);
  return 4.0 * pi * s * s;
}

// The same as a polynomial in s = r^2, for r up to pi: within 1e-6 of it, and far cheaper than a sine. Found by tools/fit_cap.
float cap_area_polynomial(float s) {
  return s * (3.1415895 + s * (-0.26178565 + s * (0.008716486 + s * (-0.00015310885 + s * 1.423226e-6))));
}

// Squared radius of a hemisphere. Fits for radii up to a hemisphere use it for larger radii too, where their polynomial would
// diverge.
const float hemisphere_squared = 2.4674011;

// How far the caps overlap: 1 where the smaller one lies inside the other, 0 where they are apart. Linear in d.
// Written as a quotient of what cannot be 0 / 0: the smaller radius is above 0.
float cap_overlap(float r0, float r1, float d) {
  float smaller = min(r0, r1);
  return clamp((r0 + r1 - d) / (2.0 * smaller), 0.0, 1.0);
}

#endif
