// SPDX-License-Identifier: Apache-2.0
// Burley's profile of the width that fits it best.
float burley_sum(float r) { return (exp(-r / 0.411) + exp(-r / 1.233)) / (25.1327412 * 0.411 * max(r, 1e-4)); }
