// SPDX-License-Identifier: Apache-2.0
// What the neighbours of a pixel hold: light of the same surface, or background that is not before it. Include after
// common/frame.glsl with clip_from_view.
#include "clip_planes.glsl"
#include "reconstruction.glsl"

layout(binding = 5) uniform sampler2D depth;          // of what is opaque
layout(binding = 6) uniform sampler2D surface_place;  // as geometry.frag writes it
layout(binding = 7) uniform sampler2D shaded;         // light of surfaces, or background

const ivec2 cross_ends[4] = ivec2[](ivec2(0, -1), ivec2(0, 1), ivec2(-1, 0), ivec2(1, 0));
const ivec2 knight_moves[8] = ivec2[](ivec2(-1, -2), ivec2(1, -2), ivec2(-2, -1), ivec2(2, -1), ivec2(-2, 1), ivec2(2, 1),
                                      ivec2(-1, 2), ivec2(1, 2));
const float depth_share = 0.02;  // standard deviation of the weight by depth, of the depth

// The surface that asks.
struct AskingSurface {
  float place;     // the object's, from 1
  float z;         // metres of view depth
  vec2 z_slope;    // metres a pixel
};

bool is_inside(ivec2 pixel) { return all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, textureSize(shaded, 0))); }

// Weight of the light that a neighbour holds: of the same object, and near its plane in depth.
float light_weight(AskingSurface surface, ivec2 pixel, ivec2 offset) {
  vec2 there = texelFetch(surface_place, clamp(pixel + offset, ivec2(0), textureSize(shaded, 0) - 1), 0).rg;
  float off = (there.y - surface.z - dot(surface.z_slope, vec2(offset))) / (depth_share * surface.z);
  return is_inside(pixel + offset) && there.x == surface.place ? exp(-off * off) : 0.0;
}

// Whether a neighbour holds background that lies behind the surface.
float background_weight(AskingSurface surface, ivec2 pixel, ivec2 offset) {
  ivec2 at = clamp(pixel + offset, ivec2(0), textureSize(shaded, 0) - 1);
  bool is_background = texelFetch(surface_place, at, 0).r == 0.0;
  bool is_behind = view_depth_of(texelFetch(depth, at, 0).r) >= (1.0 - depth_share) * surface.z;
  return is_inside(pixel + offset) && is_background && is_behind ? 1.0 : 0.0;
}

vec4 held_by(ivec2 pixel) { return texelFetch(shaded, clamp(pixel, ivec2(0), textureSize(shaded, 0) - 1), 0); }
