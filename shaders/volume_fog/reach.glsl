// SPDX-License-Identifier: Apache-2.0
// Metres of view depth that codes reach. Include after a block Frame with clip_from_view.

// `reach`: as the scene says; 0: the far plane of the view, and a ten-thousandth for what its matrix has lost.
float reached_m(float reach) {
  return reach > 0.0 ? reach : 1.0001 * clip_from_view[3][2] / (clip_from_view[2][2] + 1.0);
}
