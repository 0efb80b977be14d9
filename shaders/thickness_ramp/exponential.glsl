// SPDX-License-Identifier: Apache-2.0
// What passes an optical depth x.
float exponential(float x) { return exp(-x); }
