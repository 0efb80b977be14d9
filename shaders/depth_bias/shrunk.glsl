// SPDX-License-Identifier: Apache-2.0
// The point moved a texel along its normal into the object (Jimenez and others, "Real-Time Realistic Skin Translucency", IEEE
// CG&A 30(4), 2010), on a lit side: its path grows by the cosine. On the far side it would shrink by it.
float shrunk(float s, float slope, float u) {
  float cosine = inversesqrt(1.0 + slope * slope);
  return max(s + slope * u + cosine, 0.0);
}
