// SPDX-License-Identifier: Apache-2.0
// Which way a strand runs at a fragment, by the function that DIRECTION names:
//
//   by_tangent  along dP/dv of the texture coordinates: from root to tip of a card
//   by_map      as the direction map says
//   by_vertex   as it is painted on vertices

#ifdef DIRECTION_MAP
layout(binding = 5) uniform sampler2D hair_direction;
#endif

// Unit, square to the normal.
vec3 in_plane(vec3 along, vec3 normal, vec3 otherwise) {
  vec3 flat_ = along - normal * dot(normal, along);
  return dot(flat_, flat_) < 1e-10 ? otherwise : normalize(flat_);
}

vec3 by_tangent(SurfacePoint at) { return at.world_from_tangent[1]; }
vec3 by_vertex(SurfacePoint at) { return in_plane(in_painted, at.normal, at.world_from_tangent[1]); }
#ifdef DIRECTION_MAP
vec3 by_map(SurfacePoint at) {
  vec2 twice = texture(hair_direction, at.uv).rg * 2.0 - 1.0;
  if (dot(twice, twice) < 1e-6) return at.world_from_tangent[1];  // strands that cross
  float angle = 0.5 * atan(twice.y, twice.x);
  return at.world_from_tangent[0] * cos(angle) + at.world_from_tangent[1] * sin(angle);
}
#endif
