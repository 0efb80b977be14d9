// SPDX-License-Identifier: Apache-2.0
// The exact area in a form that stays accurate in binary32 for all radii in (0, pi).
//
// The centres and a point where the circles cross make a spherical triangle with sides r0, r1, d. A and B are its angles at the
// centres. Each circle's arc and its chord (the great circle through both crossings) bound a segment, and the two segments are the area
// (Gauss-Bonnet; Todhunter, "Spherical Trigonometry", 5th ed. 1886, sections 45 and 97):
//   area = 2 f(A, r0) + 2 f(B, r1),   f(angle, r) = atan2(cos r sin angle, cos angle) - angle cos r
// Where the closed form of f would lose digits to cancellation, other forms are used, chosen by the angle and the radius; the
// sides enter through differences taken so that they lose nothing (Kahan, "Miscalculating Area and Angles of a Needle-like
// Triangle", 2014).
#include "../common/precise_math.glsl"
#include "cap.glsl"

// An angle of the triangle in [0, pi], and what is needed of it without cancellation.
struct Corner {
  float angle, supplement;  // pi - angle
  float cosine, sine;
};

// From the squared tangent of half the angle, as a quotient.
Corner corner(float numerator, float denominator) {
  float half_sine = sqrt(numerator), half_cosine = sqrt(denominator);
  precise float sum = numerator + denominator;
  precise float cosine = (denominator - numerator) / sum;
  return Corner(2.0 * precise_atan2(half_sine, half_cosine), 2.0 * precise_atan2(half_cosine, half_sine), cosine,
                2.0 * half_sine * half_cosine / sum);
}

// sin(half the excess of the triangle over `side`): `excess` is the sum of the other two sides less this one; `gap` is 2 pi
// less all three. Beyond a right angle the gap is the more accurate of the two.
float half_sine(float excess, float gap, float side) {
  precise float angle = excess <= pi ? 0.5 * excess : 0.5 * gap + side;
  return precise_sin(min(angle, pi));
}

// f for an angle below 0.75 and a radius up to pi / 2: cos r sin^2 r times the integral of sin^2 t / (1 - sin^2 r sin^2 t) from
// 0 to the angle. Nothing cancels. Gauss-Legendre, 6 points: the error is below 1e-8 of the value.
float segment_integral(float angle, float s, float c) {
  const vec3 place = vec3(0.238619186083196909, 0.661209386466264514, 0.932469514203152028);
  const vec3 weight = vec3(0.467913934572691047, 0.360761573048138608, 0.171324492379170345);
  float sum = 0.0;
  for (int i = 0; i < 3; ++i) {
    float below = precise_sin(0.5 * angle * (1.0 - place[i])) , above = precise_sin(0.5 * angle * (1.0 + place[i]));
    sum += weight[i] * (below * below / (1.0 - s * s * below * below) + above * above / (1.0 - s * s * above * above));
  }
  return c * s * s * 0.5 * angle * sum;
}

// A circle of angular radius r: sine, cosine, 1 - cosine and 1 - |cosine|, each accurate to the last places.
struct Circle {
  float sine, cosine, versine, folded_versine;
};

float versine(float r) {
  float half_chord = precise_sin(0.5 * r);
  return 2.0 * half_chord * half_chord;
}

Circle circle(float r) {
  precise float to_hemisphere = (half_pi_high - r) + half_pi_low;
  precise float supplement = (2.0 * half_pi_high - r) + 2.0 * half_pi_low;
  return Circle(precise_sin(r), sign(to_hemisphere) * precise_sin(abs(to_hemisphere)), versine(r), versine(min(r, supplement)));
}

// f. It is odd in the circle's cosine.
float segment(Corner corner, Circle circle) {
  float c = abs(circle.cosine), area;
  if (corner.angle < 0.75) {
    area = segment_integral(corner.angle, circle.sine, c);
  } else if (c >= 0.5) {
    precise float y = circle.folded_versine * corner.sine * corner.cosine;
    precise float x = corner.cosine * corner.cosine + c * corner.sine * corner.sine;  // above 0
    area = corner.angle * circle.folded_versine - sign(y) * precise_atan2(abs(y), x);
  } else {
    float turned = precise_atan2(c * corner.sine, abs(corner.cosine));
    area = (corner.cosine < 0.0 ? 2.0 * half_pi_high - turned : turned) - c * corner.angle;
  }
  return circle.cosine < 0.0 ? -area : area;
}

// The area as two sectors less the kite of both triangles. tan(s/2) tan((s-r0)/2) tan((s-r1)/2) tan((s-d)/2) gives the
// triangle's excess (L'Huilier); the arguments are twice the four angles, with pi - s for s.
float sectors_less_kite(Corner a, Circle circle0, Corner b, Circle circle1, vec3 over, float gap) {
  float q0 = precise_sin(0.25 * over.x), q1 = precise_sin(0.25 * over.y), qd = precise_sin(0.25 * over.z), qs = precise_sin(0.25 * gap);
  float p0 = sqrt(1.0 - q0 * q0), p1 = sqrt(1.0 - q1 * q1), pd = sqrt(1.0 - qd * qd), ps = sqrt(1.0 - qs * qs);
  float excess = 4.0 * precise_atan2(sqrt(ps * q0 * q1 * qd), sqrt(qs * p0 * p1 * pd));
  precise float area = 2.0 * (a.angle * circle0.versine + b.angle * circle1.versine - excess);
  return area;
}

// Nearly a hemisphere, and the corner near neither end: there the closed form of f comes close to 0 / 0.
bool is_flat(Corner corner, Circle circle) {
  return abs(circle.cosine) < 0.1 && corner.angle > 0.75 && corner.supplement > 0.75;
}

Corner outside(Corner corner) { return Corner(corner.supplement, corner.angle, -corner.cosine, corner.sine); }

float exact_cap(float r0, float r1, float d) {
  // Twice (s - r0), (s - r1), (s - d) and (pi - s), s being half the sum of the sides: each sum pairs the larger sides first.
  float longest = max(d, max(r0, r1)), shortest = min(d, min(r0, r1));
  float middle = max(min(r0, r1), min(max(r0, r1), d));
  precise float over_longest = shortest - (longest - middle);
  precise float over_middle = shortest + (longest - middle);
  precise float over_shortest = longest + (middle - shortest);
  precise float gap = (((4.0 * half_pi_high - longest) - middle) - shortest) + 4.0 * half_pi_low;
  if (over_longest <= 0.0) return longest == d ? 0.0 : 2.0 * pi * versine(min(r0, r1));
  Circle circle0 = circle(r0), circle1 = circle(r1);
  // -2 pi (cos r0 + cos r1), the shared area of two caps that cover the sphere, as a product: the sum cancels where r0 + r1 is
  // near pi.
  float larger = max(r0, r1), smaller = min(r0, r1);
  precise float beyond = ((larger - 2.0 * half_pi_high) + smaller) - 2.0 * half_pi_low;         // r0 + r1 - pi
  precise float to_opposite = ((2.0 * half_pi_high - larger) + 2.0 * half_pi_low) + smaller;  // pi - |r0 - r1|
  float all_around = 4.0 * pi * sign(beyond) * precise_sin(0.5 * abs(beyond)) * precise_sin(0.5 * to_opposite);
  if (gap <= 0.0) return max(all_around, 0.0);

  vec3 sides = vec3(r0, r1, d);
  vec3 over = mix(mix(vec3(over_shortest), vec3(over_middle), equal(sides, vec3(middle))), vec3(over_longest), equal(sides, vec3(longest)));
  float sin_s = gap <= pi ? precise_sin(0.5 * gap) : precise_sin(0.5 * (longest + (middle + shortest)));
  float sin_0 = half_sine(over.x, gap, r0), sin_1 = half_sine(over.y, gap, r1), sin_d = half_sine(over.z, gap, d);
  Corner a = corner(sin_0 * sin_d, sin_s * sin_1);
  Corner b = corner(sin_1 * sin_d, sin_s * sin_0);

  float area;
  if (is_flat(a, circle0) || is_flat(b, circle1))
    area = sectors_less_kite(a, circle0, b, circle1, over, gap);
  else if (circle0.cosine < 0.0 && circle1.cosine < 0.0)
    area = all_around - 2.0 * (segment(outside(a), circle0) + segment(outside(b), circle1));
  else
    area = 2.0 * (segment(a, circle0) + segment(b, circle1));
  return max(area, 0.0);
}
