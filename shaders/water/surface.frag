// SPDX-License-Identifier: Apache-2.0
// A point of the water's surface: what is under it, what is reflected in it, the sun's glitter and foam. From below, water shows
// the world above by Snell's law and, beyond the critical angle, its own light; the way from the eye to the surface takes nothing.
// NORMAL: exact_normal, gems_normal, sine_normal, of each pixel; or VERTEX_NORMAL, of the mesh.
#include "effect.glsl"
#include "waves.glsl"
#include "common/surface.glsl"
#ifdef RGBM
#include "rgbm8/rgbm8.glsl"
#endif
#include "optics.glsl"
#include "fresnel_share.glsl"
#include "reflection.glsl"
#include "refraction.glsl"
#include "bottom.glsl"
#include "top.glsl"

layout(location = 0) in vec3 in_position;
layout(location = 1) in vec2 in_ground;
layout(location = 2) in vec3 in_normal;
layout(location = 0) out vec4 out_color;

void main() {
  vec2 across = dFdx(in_ground), down = dFdy(in_ground);
  float lost = 0.0, pixel_m = max(length(across), length(down));
  // Details narrower than a pixel's narrower side cannot be drawn; its longer side averages them too.
  WavePoint point = wave_point(in_ground, pixel_m, lost);
#ifdef VERTEX_NORMAL
  vec3 normal = normalize(in_normal);
#else
  vec3 normal = NORMAL(point);
#endif
  bool under = eye_world.y < height;
  vec3 to_eye = normalize(eye_world.xyz - in_position);
  normal = under ? -normal : normal;
  // The backs of waves, which a finer mesh would hide, are bent towards the eye.
  normal = normalize(normal + max(0.01 - dot(normal, to_eye), 0.0) * to_eye);
  float cosine = clamp(dot(normal, to_eye), 0.01, 1.0), index = under ? 1.0 / refraction_index : refraction_index;

  float own_depth = 1.0 / gl_FragCoord.w;
  Behind straight = behind_at(gl_FragCoord.xy * frame_size_px.zw);
  vec3 refracted = refract(-to_eye, normal, 1.0 / index);
  refracted = dot(refracted, refracted) > 0.5 ? refracted : -to_eye;  // all is reflected: not seen
  Behind found = refracted_behind(in_position, refracted, own_depth, straight, under);
  vec3 behind = color_at(found.place);
  float way_m = max(distance(found.position, in_position), 0.0);
  vec3 body = under ? behind : bottom_light(behind, found, way_m, pixel_m) + in_scatter(refracted, way_m);

  vec3 along = reflect(-to_eye, normal);
  vec3 mirrored = under ? in_scatter(normalize(vec3(along.x, min(along.y, -1e-3), along.z)), bottom_far_m) : reflected_light(in_position, along);
  float share = reflected_share(cosine, index, lost);
#ifdef SOFT_EDGE
  float edge = clamp((straight.view_depth - own_depth) / soft_edge, 0.0, 1.0);
#else
  const float edge = 1.0;
#endif
  vec3 color = mix(body, mirrored, share * edge);
#ifdef SPECULAR
  color += under ? vec3(0.0) : edge * share * glitter(along, lost);
#endif
#ifdef FOAM
  float cover = under ? 0.0 : edge * foam_cover(in_position, straight, way_m);
  color = mix(color, foam_light(normal, in_position), cover);
#endif
  out_color = vec4(min(color, vec3(6e4)), 1.0);
}
