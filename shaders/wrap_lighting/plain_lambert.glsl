// SPDX-License-Identifier: Apache-2.0
// No wrap.
float plain_lambert(float c, float w) { return max(c, 0.0); }
