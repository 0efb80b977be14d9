// SPDX-License-Identifier: Apache-2.0
// As the slide prints it: the intensities weigh the mapped normal, so that red sees it most.
float blended_printed(float vertex, float bump, float red, float rest) {
  return clamp(min(mix(vertex, bump, red), mix(vertex, bump, rest)), 0.0, 1.0);
}
