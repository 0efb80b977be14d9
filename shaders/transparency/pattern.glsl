// SPDX-License-Identifier: Apache-2.0
// Which pixels hold the light of a transparent surface; the others hold the background. CHECKERBOARD: every second one (Drobot,
// a deferred renderer with one transparent layer); QUAD_STIPPLE: one of each 2x2 (Kircher and Lawrance, "Inferred Lighting",
// Sandbox 2009). PARITY, 0 or 1, moves the pattern by a pixel.

bool holds_light(ivec2 pixel) {
#ifdef CHECKERBOARD
  return ((pixel.x + pixel.y + PARITY) & 1) == 1;
#else
  return ((pixel.x + PARITY) & pixel.y & 1) == 1;
#endif
}
