// SPDX-License-Identifier: Apache-2.0
// What a refracted ray meets, found in the picture of what lies below. REFRACTION: to_depth (down to the depth of what is behind the
// pixel, and again from what is found there, LANDINGS_BELOW times), marched (along the ray to the first surface that it crosses, in
// MARCH_STEPS steps, and to_depth where it crosses none), as_long_as (as long as the unrefracted way), unbent.
#define to_depth 0
#define as_long_as 1
#define unbent 2
#define marched 3
#include "refraction_way/refraction_way.glsl"
#include "below_picture.glsl"

const float unknown_way_m = 8.0;  // where a ray is looked for whose pixel shows nothing below
const float endless_m = 1e3;      // of a ray that is followed

float view_depth_of(vec3 world) { return (clip_from_world * vec4(world, 1.0)).w; }
// Where a point of the ray stands on the frame.
vec2 place_of(vec3 world, vec2 otherwise) {
  vec4 clip = clip_from_world * vec4(world, 1.0);
  return clip.w > 1e-4 ? clip.xy / clip.w * 0.5 + 0.5 : otherwise;
}

// The way to the place along the ray that is as deep as what was found.
float way_down(vec3 from, vec3 along, Behind found, Behind straight, bool under) {
  if (found.view_depth >= bottom_far_m) return unknown_way_m;
#if REFRACTION == as_long_as
  return distance(straight.position, from);
#else
  return under ? distance(straight.position, from) : way_to_depth(-along.y, max(from.y - found.position.y, 0.0));
#endif
}

#if REFRACTION == marched
// A ray on the picture: straight, and straight in the inverse of depth.
struct PictureRay {
  vec2 first, last;
  float first_inverse, last_inverse, reach;
};
vec2 place_on(PictureRay ray, float t) { return mix(ray.first, ray.last, t); }
float depth_on(PictureRay ray, float t) { return 1.0 / mix(ray.first_inverse, ray.last_inverse, t); }
float way_on(PictureRay ray, float t) { return ray.reach * t * ray.last_inverse * depth_on(ray, t); }
// How far behind a layer's surface it is; of one that is turned away from the eye, how far before. either_layer: behind the hidden one
// where it is behind the first, and there is one.
const int either_layer = 3;
float behind_by(PictureRay ray, int layer, float t) {
  float depth = depth_on(ray, t), off = depth - smooth_depth_at(layer == either_layer ? first_layer : layer, place_on(ray, t));
  if (layer == turned_layer) return -off;
  if (layer != either_layer || off <= 0.0) return off;
  float hidden = smooth_depth_at(hidden_layer, place_on(ray, t));
  return hidden < bottom_far_m ? depth - hidden : off;
}

const float touch_share = 0.01;  // of a depth: what is next to nothing

// Where, from `before` to `after`, the ray crosses the layer's surface; below 0 where it only passes behind its edge: there the
// distance to the surface jumps, however short the step.
float crossing(PictureRay ray, int layer, float before, float after) {
  // Between texels it may cross a little before or after.
  float more = after - before, off_before = behind_by(ray, layer, before), off_after = behind_by(ray, layer, after);
  if (off_before > 0.0) off_before = behind_by(ray, layer, before = max(before - more, 0.0));
  if (off_after <= 0.0) off_after = behind_by(ray, layer, after += more);
  if (off_before > 0.0 || off_after <= 0.0) return -1.0;
  float whole = off_after - off_before;
  for (int i = 0; i < 6; ++i) {
    float middle = 0.5 * (before + after), off = behind_by(ray, layer, middle);
    if (off > 0.0) {
      after = middle, off_after = off;
    } else {
      before = middle, off_before = off;
    }
  }
  // Where it jumps, but from or to next to nothing, an edge stands just where the ray meets the surface.
  bool touches = min(-off_before, off_after) < touch_share * depth_on(ray, before);
  float met = off_after - off_before < 0.25 * whole ? mix(before, after, off_before / min(off_before - off_after, -1e-9)) : -1.0;
  return met < 0.0 && touches ? (-off_before < off_after ? before : after) : met;
}
#if BELOW_LAYERS > 1

// Behind the first surface and before what looks away from the eye behind it: within a thing.
bool is_within(float depth, vec2 place) {
  float turned = below_depth_at(turned_layer, place);
  return depth > below_depth_at(first_layer, place) && depth < turned && turned < bottom_far_m;
}
// Where, from `before` to `after`, the ray comes into a thing over its edge, on the side that looks away from the eye; below 0 where
// neither of its faces is near.
float entering(PictureRay ray, float before, float after, out int layer) {
  for (int i = 0; i < 6; ++i) {
    float middle = 0.5 * (before + after);
    bool is_in = is_within(depth_on(ray, middle), place_on(ray, middle));
    before = is_in ? before : middle;
    after = is_in ? middle : after;
  }
  float off = abs(behind_by(ray, first_layer, after)), off_turned = abs(behind_by(ray, turned_layer, after));
  layer = off_turned < off ? turned_layer : first_layer;
  return min(off, off_turned) < 5.0 * touch_share * depth_on(ray, after) ? after : -1.0;
}
#endif

// The share of the way from one place of the picture to another that lies within it.
float share_within(vec2 first, vec2 last) {
  vec2 step_uv = last - first, edge = vec2(step_uv.x < 0.0 ? 0.0 : 1.0, step_uv.y < 0.0 ? 0.0 : 1.0);
  vec2 share = (edge - first) / vec2(abs(step_uv.x) < 1e-9 ? 1e-9 : step_uv.x, abs(step_uv.y) < 1e-9 ? 1e-9 : step_uv.y);
  return clamp(min(share.x, share.y), 0.0, 1.0);
}

// The first surface that the ray crosses within the picture: its way, and its layer; a way below 0 where it meets none. Steps are
// even on the picture.
float marched_way(vec3 from, vec3 along, vec2 from_place, out int layer) {
  float start = view_depth_of(from), ahead = view_depth_of(from + along) - start;
  // Towards the eye: as far as a way that does not pass it.
  float reach = ahead < 0.0 ? min(endless_m, 0.8 * start / -ahead) : endless_m;
  PictureRay ray = PictureRay(from_place, place_of(from + reach * along, from_place), 1.0 / start, 1.0 / (start + reach * ahead), reach);
  float found = -1.0, within = share_within(below_place(ray.first), below_place(ray.last));
  layer = 0;
  bool was_behind = start > below_depth_at(0, ray.first);
#if BELOW_LAYERS > 1
  float was_hidden_by = start - below_depth_at(1, ray.first);
  bool was_in = false;
#endif
  for (int i = 1; i <= MARCH_STEPS && found < 0.0; ++i) {
    float before = within * float(i - 1) / float(MARCH_STEPS), t = within * float(i) / float(MARCH_STEPS), depth = depth_on(ray, t);
    vec2 place = place_on(ray, t);
    bool is_behind = depth > below_depth_at(0, place);
    bool is_crossed = is_behind && !was_behind;
    if (is_crossed) found = crossing(ray, 0, before, t);
#if BELOW_LAYERS > 1
    // A surface that was hidden may not be any more: what hid it ends here. Or it is hidden from here on.
    float hidden_by = depth - below_depth_at(1, place);
    bool was_between = was_behind && was_hidden_by <= 0.0 && was_hidden_by > -0.5 * bottom_far_m;
    is_crossed = is_crossed || (hidden_by > 0.0 && was_hidden_by <= 0.0) || (was_between && hidden_by < -0.5 * bottom_far_m);
    if (found < 0.0 && is_behind && is_crossed) {
      found = crossing(ray, either_layer, before, t);
      layer = found >= 0.0 && abs(behind_by(ray, 1, found)) < abs(behind_by(ray, 0, found)) ? 1 : 0;
    }
    was_hidden_by = hidden_by;
    bool is_in = is_within(depth, place);
    if (found < 0.0 && is_in && !was_in) {
      int entered = 0;
      found = entering(ray, before, t, entered);
      layer = found >= 0.0 ? entered : layer;
    }
    was_in = is_in;
#endif
    was_behind = is_behind;
  }
  return found < 0.0 ? found : way_on(ray, found);
}
#endif

// What the ray from a point of the surface meets. What is nearer than the water, or over it, is not behind it: then it is what
// stands behind the pixel, with the depth of that. Seen from under the water it is taken to be as far as that.
Behind refracted_behind(vec3 from, vec3 along, float own_depth, Behind straight, bool under) {
#if REFRACTION == unbent
  return straight;
#else
  Behind found = straight;
#if REFRACTION == as_long_as
  const int landings = 1;
#else
  const int landings = LANDINGS_BELOW;
#endif
  for (int i = 0; i < landings; ++i) {
    float way = min(way_down(from, along, found, straight, under), bottom_far_m);
    vec2 place = place_of(from + way * along, straight.place), on = below_place(place);
    // Beyond the picture's edges nothing is known: the ray bends less.
    vec2 inside = clamp(min(on, 1.0 - on) / 0.03, 0.0, 1.0);
    place = inside.x * inside.y > 0.0 ? mix(straight.place, place, inside.x * inside.y) : straight.place;
    Behind next = behind_at(0, place);
    if (next.view_depth > own_depth && (under || next.position.y < from.y)) found = next;
  }
#if REFRACTION == marched
  int layer = 0;
  float way = under ? -1.0 : marched_way(from, along, straight.place, layer);
  if (way >= 0.0) {
    vec3 met = from + way * along;
    found = behind_at(layer, place_of(met, straight.place));
    found.position = met;
  }
#endif
  return found;
#endif
}
