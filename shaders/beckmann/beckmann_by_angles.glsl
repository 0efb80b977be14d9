// SPDX-License-Identifier: Apache-2.0
// As listings have it, by the angle itself: where devices approximate acos and tan, their errors count.
float beckmann_by_angles(float nh, float m) {
  float tangent = tan(acos(nh));
  return exp(-(tangent * tangent) / (m * m)) / (m * m * pow(nh, 4.0));
}
