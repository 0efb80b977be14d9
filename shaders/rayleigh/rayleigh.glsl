// SPDX-License-Identifier: Apache-2.0
// Which share of scattered light goes into a direction, a steradian, by molecules (Rayleigh), and two misprints of it.

float rayleigh_phase(float cosine) { return 0.0596831037 * (1.0 + cosine * cosine); }  // 3 / (16 pi)

// 3 pi / 16, as a comment in a published sample has the factor.
float upside_down_rayleigh(float cosine) { return 0.589048623 * (1.0 + cosine * cosine); }

// 0.75 + 0.75 (1 + cos^2) over 4 pi, as copies have it.
float twice_added_rayleigh(float cosine) { return 0.0795774715 * (0.75 + 0.75 * (1.0 + cosine * cosine)); }

// By the function that RAYLEIGH names.
#ifdef RAYLEIGH
float rayleigh(float cosine) { return RAYLEIGH(cosine); }
#endif
