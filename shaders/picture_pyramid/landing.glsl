// SPDX-License-Identifier: Apache-2.0
// Where rays land on a picture of the scene, of which `on_picture(world)` gives clip space: x right, y down, w metres along the
// view's axis. A shader declares it before it includes this.
layout(binding = 4) uniform sampler2D view_depth;  // of what the picture shows: metres along the view's axis; 1e30 where nothing is

const float far_m = 1e5;  // what is further is seen by its direction alone

struct LeavingRay {
  vec3 from, direction;
  bool passes;  // else a facet looks away, or the ray does not leave
};

float view_depth_of(vec3 world) { return on_picture(vec4(world, 1.0)).w; }
float depth_at(vec2 uv) {
  ivec2 size = textureSize(view_depth, 0);
  return min(texelFetch(view_depth, clamp(ivec2(uv * vec2(size)), ivec2(0), size - 1), 0).r, far_m);
}
// The pixel that is drawn.
vec2 own_place() { return gl_FragCoord.xy * frame_size_px.zw; }

// Where on the picture (0 to 1) the ray is at a view depth. A ray that goes backwards is taken to stay where it leaves.
vec2 picture_at(LeavingRay ray, float depth) {
  float ahead = on_picture(vec4(ray.direction, 0.0)).w, start = view_depth_of(ray.from);
  vec4 clip = on_picture(vec4(ray.from + ray.direction * (ahead > 1e-4 ? max(depth - start, 0.0) / ahead : 0.0), 1.0));
  return clip.xy / clip.w * 0.5 + 0.5;
}

// Where the ray meets what the picture shows: taken to lie as deep as what is there, found in two steps from `start`.
vec2 landing(LeavingRay ray, float start) {
  vec2 uv = picture_at(ray, start);
  return picture_at(ray, max(depth_at(uv), view_depth_of(ray.from)));
}
