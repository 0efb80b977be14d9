// SPDX-License-Identifier: Apache-2.0
// How far rays through the slab spread on the picture.
#include "slab.glsl"
#include "picture_pyramid/spread.glsl"

Spread spread_of(SurfacePoint at, vec3 to_eye) {
  float off = roughness * roughness * 0.70710678;
  return spread_of_rays(through_slab(at, to_eye, vec2(0.0)), through_slab(at, to_eye, vec2(off, 0.0)),
                        through_slab(at, to_eye, vec2(0.0, off)), at.position);
}
