// SPDX-License-Identifier: Apache-2.0
// The closed form alone, as engines have it: near 0 and near 1 differences lose their digits.
float burley_closed(float u) {
  float w = 2.0 * (1.0 - u), g = pow(w + sqrt(w * w + 1.0), 1.0 / 3.0);
  return -3.0 * log(g - 1.0 / g);
}
