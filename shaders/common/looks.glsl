// SPDX-License-Identifier: Apache-2.0
// How a picture that was drawn before is read over a pixel. A texel of it is blurred as wide as a box, and a tent between texels: 3/12
// of its width squared. A pixel sees 1/12 of its own, as wide as neighbours read apart. What is missing is made good by four looks, none
// in a row or column with another; what is too much is taken off along each axis by what stands a texel beside (an unsharp mask).
#ifndef LOOKS_GLSL
#define LOOKS_GLSL
struct Looks {
  vec2 right, down;  // from one neighbour to the other, by which looks are spread
  vec2 texel;        // of the picture
  vec2 sharpened;    // how much of what stands beside is taken off, along each axis
};

const vec2 looks_at[4] = vec2[](vec2(-0.375, 0.125), vec2(-0.125, -0.375), vec2(0.125, 0.375), vec2(0.375, -0.125));

// One look, as it is: where neighbours read other things.
Looks one_look(vec2 texel) { return Looks(vec2(0.0), vec2(0.0), texel, vec2(0.0)); }

// `right`, `down`: from where a pixel reads to where its neighbours do; `texel`: the picture's; all as parts of the picture.
Looks looks_over(vec2 right, vec2 down, vec2 texel) {
  vec2 seen = right * right + down * down, missing = seen - 3.0 * texel * texel;
  // The four looks have a variance of 5/64 of the squares of what they are spread over.
  vec2 spread = sqrt(clamp(16.0 / 15.0 * missing / max(seen, 1e-20), 0.0, 1.0));
  return Looks(spread * right, spread * down, texel, clamp(-missing / (24.0 * texel * texel), 0.0, 0.125));
}

vec2 look_at(Looks looks, int i) { return looks_at[i].x * looks.right + looks_at[i].y * looks.down; }
#endif
