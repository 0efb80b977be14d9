// SPDX-License-Identifier: Apache-2.0
// The wider exponential's share alone, as if it were all: cheap, and wrong in the middle.
float burley_exponential(float u) { return -3.0 * log(max(1.0 - u, 1e-30)); }
