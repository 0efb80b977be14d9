// SPDX-License-Identifier: Apache-2.0
// Lambert's cosine wrapped around the edge (Green, GDC 2004), divided by what it adds up to over the sphere (as Unity's
// ComputeWrappedDiffuseLighting and Filament's Fd_Wrap do).
#ifndef NORMALISED_WRAP_GLSL
#define NORMALISED_WRAP_GLSL
float normalised_wrap(float c, float w) { return max(c + w, 0.0) / ((1.0 + w) * (1.0 + w)); }
#endif
