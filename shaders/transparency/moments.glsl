// SPDX-License-Identifier: Apache-2.0
// Transmittance from four power moments of absorbance over depth: Muenstermann, Krumpen, Klein and Peters, "Moment-Based
// Order-Independent Transparency", I3D 2018; the Hankel system as in Peters and Klein, "Moment Shadow Mapping", I3D 2015.

// -log(1 - alpha), for an alpha of up to 1, which counts as 0.99999.
float absorbance_of(float alpha) { return -log(1.0 - min(alpha, 0.99999)); }

// The logarithm of view depth, from -1 at `near` to 1 at `far` (metres).
float moment_depth(float z, float near, float far) { return log(z / near) / log(far / near) * 2.0 - 1.0; }

// exp(-absorbance before `depth`): what reaches the eye from there. `moments`: of absorbance times depth^1 to depth^4, over
// `total`, the absorbance of all. `bias` moves them towards those of an even distribution, so that the system below is not
// singular: with one layer it has rank 1. `overestimation`: the share of what lies at `depth` itself that counts as before it.
float moment_transmittance(float total, vec4 moments, float depth, float bias, float overestimation) {
  vec4 b = mix(moments, vec4(0.0, 0.375, 0.0, 0.375), bias);
  // Cholesky's factors of ((1, b1, b2), (b1, b2, b3), (b2, b3, b4)).
  float variance = b.y - b.x * b.x, skew = b.z - b.x * b.y, slope = skew / variance;
  float rest = b.w - b.y * b.y - slope * skew;
  // c with B c = (1, depth, depth^2): the polynomial whose roots are the other two points.
  vec3 c = vec3(1.0, depth - b.x, depth * depth - b.y);
  c.z -= slope * c.y;
  c.y /= variance, c.z /= rest;
  c.y -= slope * c.z;
  c.x -= b.x * c.y + b.y * c.z;
  float middle = -0.5 * c.y / c.z, apart = sqrt(max(middle * middle - c.x / c.z, 0.0));
  vec3 points = vec3(depth, middle - apart, middle + apart);
  // The polynomial through these points that is 1 before `depth` and 0 behind, in Newton's form; its mean by the moments.
  vec3 before = vec3(overestimation, points.y < depth ? 1.0 : 0.0, points.z < depth ? 1.0 : 0.0);
  float first = (before.y - before.x) / (points.y - points.x);
  float last = (before.z - before.y) / (points.z - points.y), second = (last - first) / (points.z - points.x);
  float share = before.x + first * (b.x - points.x) + second * (b.y - (points.x + points.y) * b.x + points.x * points.y);
  return exp(-total * clamp(share, 0.0, 1.0));
}
