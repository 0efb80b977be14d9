// SPDX-License-Identifier: Apache-2.0
// The wrapped cosine squared, its energy kept (power form with p = 2): rounder at the edge.
float power_wrap(float c, float w) {
  float wrapped = max((c + w) / (1.0 + w), 0.0);
  return wrapped * wrapped * (3.0 / (2.0 + 2.0 * w));
}
