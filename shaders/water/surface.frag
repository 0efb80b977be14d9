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

#ifdef RIPPLES
layout(binding = 13) uniform sampler2D ripple_table;
// Slopes are added, not normals: of two patterns that drift, the second turned by a quarter.
vec3 with_ripples(vec3 normal, vec2 ground) {
  vec2 at = ground / ripple_size;
  float time = eye_world.w;
  vec2 first = texture(ripple_table, at + vec2(0.05, 0.021) * time).rg,
       second = texture(ripple_table, 1.31 * vec2(-at.y, at.x) + vec2(-0.037, 0.043) * time).rg;
  vec2 slopes = -normal.xz / max(normal.y, 0.05) + 0.70710678 * ripples * (first + vec2(second.y, -second.x));
  return normalize(vec3(-slopes.x, 1.0, -slopes.y));
}
#endif

#ifdef SPLASHES
#include "splash_map.glsl"
layout(binding = 17) uniform sampler2D splash_slopes;
// The slopes of waves that objects throw back are added too.
vec3 with_splashes(vec3 normal, vec2 at) {
  vec2 place = splash_place(at), slopes = -normal.xz / max(normal.y, 0.05);
  slopes += splashes * splash_fade(place) * textureLod(splash_slopes, place, 0.0).rg;
  return normalize(vec3(-slopes.x, 1.0, -slopes.y));
}
#endif

layout(location = 0) in vec3 in_position;
layout(location = 1) in vec2 in_ground;
layout(location = 2) in vec3 in_normal;
#ifdef TOLD
// For the truth: which point of the surface a pixel shows, by where it lies without waves, and what is found below and above.
layout(location = 0) out vec4 out_ground;
layout(location = 1) out vec4 out_mirrored;
layout(location = 2) out vec4 out_bottom;     // the light of what is met below,
layout(location = 3) out vec4 out_kept;       // what of it comes up to the surface,
layout(location = 4) out vec4 out_scattered;  // and what the way adds
#else
layout(location = 0) out vec4 out_color;
#endif

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
#ifdef RIPPLES
  normal = with_ripples(normal, in_ground);
#endif
#ifdef SPLASHES
  normal = with_splashes(normal, in_position.xz);
#endif
  bool under = eye_world.y < height;
  vec3 to_eye = normalize(eye_world.xyz - in_position);
  normal = under ? -normal : normal;
  // The backs of waves, which a finer mesh would hide, are bent towards the eye.
  normal = normalize(normal + max(0.01 - dot(normal, to_eye), 0.0) * to_eye);
  float cosine = clamp(dot(normal, to_eye), 0.01, 1.0), index = under ? 1.0 / refraction_index : refraction_index;

  float own_depth = 1.0 / gl_FragCoord.w;
  Behind straight = behind_at(0, gl_FragCoord.xy * frame_size_px.zw);
  vec3 refracted = refract(-to_eye, normal, 1.0 / index);
  refracted = dot(refracted, refracted) > 0.5 ? refracted : -to_eye;  // all is reflected: not seen
  Behind found = refracted_behind(in_position, refracted, own_depth, straight, under);
  float way_m = max(distance(found.position, in_position), 0.0);
  // Red and blue by their own indices (1.3310, 1.3335, 1.3372 of water), as deep as green goes.
  vec2 red_place = vec2(0.0), blue_place = vec2(0.0);
#ifdef DISPERSION
  vec3 red = refract(-to_eye, normal, 1.0 / (index - 0.0025 * dispersion));
  vec3 blue = refract(-to_eye, normal, 1.0 / (index + 0.0037 * dispersion));
  float seen_m = min(max(in_position.y - found.position.y, 0.0), bottom_far_m);
  red_place = under ? vec2(0.0) : place_of(in_position + way_to_depth(-red.y, seen_m) * red, found.place) - found.place;
  blue_place = under ? vec2(0.0) : place_of(in_position + way_to_depth(-blue.y, seen_m) * blue, found.place) - found.place;
#endif
#ifdef BLUR_LEVELS
  // Turbid water blurs what is far: from level to level of the picture's pyramid, by the share of light that is scattered on the way.
  MetLight met = met_over_pixel(found, red_place, blue_place, pixel_m, BLUR_LEVELS * (1.0 - exp(-scattered().g * way_m)));
#else
  MetLight met = met_over_pixel(found, red_place, blue_place, pixel_m);
#endif
  vec3 added = under ? vec3(0.0) : in_scatter(refracted, way_m);
  vec3 body = under ? met.sun + met.rest : bottom_light(met, found, way_m) + added;

  vec3 along = reflect(-to_eye, normal);
  vec3 level = normalize(vec3(along.x, min(along.y, -1e-3), along.z));
  vec3 mirrored = under ? in_scatter(level, bottom_far_m) : reflected_light(in_position, along);
#ifdef TOLD
  out_ground = vec4(in_ground, in_position.y, 1.0);
  out_mirrored = vec4(mirrored, 1.0);
  out_bottom = vec4(met.sun + met.rest, 1.0);
  // Of what is black, as of what is hardly lit.
  MetLight hardly = MetLight(met.sun + 1e-9 * found.sun_share, met.rest + 1e-9 * (1.0 - found.sun_share));
  out_kept = vec4(bottom_light(hardly, found, way_m) / (hardly.sun + hardly.rest), 1.0);
  out_scattered = vec4(added, 1.0);
#else
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
#endif
}
