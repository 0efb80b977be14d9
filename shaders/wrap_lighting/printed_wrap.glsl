// SPDX-License-Identifier: Apache-2.0
// As Green's slide prints it: it adds up to 1 + w times what Lambert's cosine does.
float printed_wrap(float c, float w) { return max((c + w) / (1.0 + w), 0.0); }
