// SPDX-License-Identifier: Apache-2.0
// The ray that a pixel shows, and how far it goes. Frame must have view_from_world and clip_from_view.

// In the planet's frame, from the eye; `along_axis`: metres of it for a metre along the view's axis.
AirRay seen_ray(vec2 place_px, out float along_axis) {
  vec2 clip = 2.0 * place_px * frame_size_px.zw - 1.0;
  vec3 in_view = vec3(clip.x / clip_from_view[0].x, clip.y / clip_from_view[1].y, -1.0);
  along_axis = length(in_view);
  return air_ray(eye_world.xyz - vec3(0.0, sea_level, 0.0), transpose(mat3(view_from_world)) * in_view / along_axis);
}

// The air on the way to what the pixel shows: to a solid thing, or beyond all (view_depth 1e30) to the planet or into space.
vec2 seen_span(AirRay ray, float view_depth, float along_axis) {
  bool solid = view_depth < 1e29;
  float end = solid ? view_depth * along_axis : meets_planet(ray) ? planet_distance(ray) : 1e30;
  return span_in_air(ray, end);
}
